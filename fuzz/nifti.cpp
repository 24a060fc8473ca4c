// Fuzzes the reader of .nii and .nii.gz files.
#include "SourceUse.h"

#include "Input/Openers/Openers.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  using namespace voxc::fuzz;
  readVoxels(voxc::openNifti(folder().write("m.nii", textOf(data, size)), fuzzedOptions()));
  return 0;
}
