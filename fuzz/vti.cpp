// Fuzzes the reader of .vti files.
#include "SourceUse.h"

#include "Input/Openers/Openers.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  using namespace voxc::fuzz;
  readVoxels(voxc::openVtk(folder().write("m.vti", textOf(data, size)), fuzzedOptions()));
  return 0;
}
