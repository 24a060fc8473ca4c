// Fuzzes the reader of the pages of TIFF files.
#include "SourceUse.h"

#include "Input/Openers/Openers.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  using namespace voxc::fuzz;
  readVoxels(voxc::openSlices(folder().write("m.tif", textOf(data, size)), fuzzedOptions()));
  return 0;
}
