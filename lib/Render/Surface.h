// Where a ray meets the volume, and which way its surface faces there.
#pragma once

#include "voxc/Render/SurfaceNormals.h"
#include "voxc/Trace/Ray.h"

#include <glm/vec3.hpp>

namespace voxc {

struct Surface {
  glm::vec3 point{};
  glm::vec3 normal{}; ///< Towards the eye, unit length.
  glm::vec3 start{};  ///< Of rays to the light.
};

inline glm::vec3 vectorOf(const float (&numbers)[3]) { return {numbers[0], numbers[1], numbers[2]}; }

/// The surface that `ray` hit: the face of the voxel, or with `normals` what they know of it.
Surface surfaceOf(const Ray &ray, const Hit &hit, const SurfaceNormals *normals);

} // namespace voxc
