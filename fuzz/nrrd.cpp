// Fuzzes the reader of .nrrd files.
#include "SourceUse.h"

#include "Input/Openers/Openers.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  using namespace voxc::fuzz;
  readVoxels(voxc::openNrrd(folder().write("m.nrrd", textOf(data, size)), fuzzedOptions()));
  return 0;
}
