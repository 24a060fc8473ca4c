// Whether a kernel fits a volume.
#include "KernelFit.h"

namespace voxc {

Expected<void> checkFit(std::uint64_t storageDigest, const Volume &volume, std::string_view emit) {
  if (storageDigest == volume.storageDigest())
    return {};
  return Error::input("this kernel was made for another format than the volume's: compile one with `voxc "
                      "compile '" +
                      toString(volume.format()) + "' --emit=" + std::string(emit) +
                      "` and the passes that the volume was built with");
}

} // namespace voxc
