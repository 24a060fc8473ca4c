// The face of a voxel by which a ray enters it, as hits report it.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>

namespace voxc {

/// The number of no face: the ray begins in the voxel.
inline constexpr std::uint32_t kNoFace = 6;

/// The normal of a face, out of the voxel, in voxel space: of 0 and 1, the low and the high face on x, (-1,
/// 0, 0) and (1, 0, 0); of 2 and 3 those on y, of 4 and 5 those on z. Of any other number, as of `kNoFace`,
/// 0.
inline glm::vec3 normalOf(std::uint32_t face) {
  glm::vec3 normal(0);
  if (face < kNoFace)
    normal[static_cast<int>(face / 2)] = face % 2 == 0 ? -1.0f : 1.0f;
  return normal;
}

} // namespace voxc
