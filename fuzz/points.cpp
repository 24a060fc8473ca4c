// Fuzzes the reader of .ply files without faces.
#include "SourceUse.h"

#include "Input/Points/PointSource.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  using namespace voxc;
  auto reader = PlyReader::open(fuzz::folder().write("m.ply", fuzz::textOf(data, size)));
  if (!reader)
    return 0;
  InputOptions options = fuzz::fuzzedOptions();
  options.resolution = 100;
  auto points = readPoints(*reader, options);
  if (!points)
    return 0;
  Input input;
  input.source = std::move(points->source);
  fuzz::readVoxels(std::move(input));
  return 0;
}
