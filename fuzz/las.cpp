// Fuzzes the reader of .las files.
#include "SourceUse.h"

#include "Input/Openers/Openers.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  using namespace voxc::fuzz;
  voxc::InputOptions options = fuzzedOptions();
  options.resolution = 100;
  readVoxels(voxc::openLas(folder().write("m.las", textOf(data, size)), options));
  return 0;
}
