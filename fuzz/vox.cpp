// Fuzzes the reader of .vox files.
#include "SourceUse.h"

#include "Input/Openers/Openers.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  using namespace voxc::fuzz;
  readVoxels(voxc::openMagicaVoxel(folder().write("m.vox", textOf(data, size)), fuzzedOptions()));
  return 0;
}
