// Fuzzes the reader of .binvox files.
#include "SourceUse.h"

#include "Input/Openers/Openers.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  using namespace voxc::fuzz;
  readVoxels(voxc::openBinvox(folder().write("m.binvox", textOf(data, size)), fuzzedOptions()));
  return 0;
}
