// Whether a kernel fits a volume.
#include "KernelFit.h"

namespace voxc {

Expected<void> checkFit(std::uint64_t storageDigest, const Volume &volume, std::string_view emit) {
  if (storageDigest == volume.storageDigest())
    return {};
  return checkFit(storageDigest, volume.storageDigest(), toString(volume.format()), emit);
}

Expected<void> checkFit(std::uint64_t storageDigest, std::uint64_t volumeDigest, std::string_view format,
                        std::string_view emit) {
  if (storageDigest == volumeDigest)
    return {};
  return Error::input(
      "this kernel was made for another format than the volume's: compile one with `voxc compile '" +
      std::string(format) + "' --emit=" + std::string(emit) +
      "` and the passes that the volume was built with");
}

Error notTraced() { return Error::usage("the volume to be replaced is not the one that this tracer traces"); }

} // namespace voxc
