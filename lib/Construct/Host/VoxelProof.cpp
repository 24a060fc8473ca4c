// Alpha and colours of voxels.
#include "VoxelProof.h"

namespace voxc {
namespace {

std::string placeText(Int3 voxel) {
  return "(" + std::to_string(voxel.x) + ", " + std::to_string(voxel.y) + ", " + std::to_string(voxel.z) +
         ")";
}

} // namespace

bool VoxelProof::isNeeded() const { return facts_.alpha == Alpha::Positive || colours_.isStated(); }

std::optional<Error> VoxelProof::prove(Int3 at, std::uint32_t word) {
  const std::string voxel = "voxel " + placeText(at) + " ";
  if (facts_.alpha == Alpha::Positive && word >> 24 == 0)
    return Error::input(
        voxel + (isToCome_ ? "would have" : "has") +
        " an alpha of 0, but the format states alpha=positive; build it without visible-voxels");
  if (colours_.isStated() && !colours_.take(word))
    return colours_.broken(voxel + (isToCome_ ? "would be" : "is"), word, isToCome_);
  return std::nullopt;
}

} // namespace voxc
