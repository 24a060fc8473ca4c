// Where a ray meets the volume, and which way its surface faces there.
#pragma once

#include "voxc/Render/SurfaceNormals.h"
#include "voxc/Trace/Clip.h"
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

/// The same where voxels have these sizes: it begins (`start`) in voxels, where rays are traced, and lies and
/// faces in spaced space, where light goes. Of a thing that is cut by `clip`, if any, it is the cut where the
/// voxel lies right behind one.
Surface spacedSurface(const Ray &ray, const Hit &hit, const SurfaceNormals *normals, const glm::vec3 &spacing,
                      const Clip *clip);

} // namespace voxc
