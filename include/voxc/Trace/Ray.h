// Rays and hits, as they lie in ray files, hit files and device buffers; docs/ir.md says which hit a ray has.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>

namespace voxc {

/// A ray in voxel space; its direction need not be unit length. 24 bytes, little-endian float32.
struct Ray {
  float origin[3];
  float direction[3];
};

/// The ray from a point in a direction, both rounded to float32.
inline Ray makeRay(const glm::vec3 &origin, const glm::vec3 &direction) {
  return {{origin.x, origin.y, origin.z}, {direction.x, direction.y, direction.z}};
}

/// The first voxel that is hit; a miss is -1, -1, -1, 0, 0. A kernel that is asked for less (`Question`) has
/// 0 in place of what is not asked. 24 bytes, little-endian.
struct Hit {
  std::int32_t voxel[3];
  std::uint32_t rgba;
  float t; ///< Smallest t with the point in the voxel; 0 if the origin lies in it.
  /// Lookups made, or words read, if they were counted. Else the face by which the ray enters the voxel, if
  /// that is asked: twice its axis, and 1 more if it is the high one; 6 if the ray begins in the voxel. Else
  /// 0.
  std::uint32_t steps;

  bool isHit() const { return voxel[0] >= 0; }
};

static_assert(sizeof(Ray) == 24 && sizeof(Hit) == 24);

} // namespace voxc
