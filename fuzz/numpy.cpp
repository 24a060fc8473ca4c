// Fuzzes the readers of .npy and .npz files.
#include "SourceUse.h"

#include "Input/Openers/Openers.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  using namespace voxc::fuzz;
  readVoxels(voxc::openNumpy(folder().write("m.npy", textOf(data, size)), fuzzedOptions()));
  readVoxels(voxc::openNumpy(folder().write("m.npz", textOf(data, size)), fuzzedOptions()));
  return 0;
}
