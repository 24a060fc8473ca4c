// Surfaces of hits.
#include "Surface.h"

#include "Trace/EntryFace.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace voxc {

namespace {

/// So far in front of a face that float32 tells it from the face.
float clearance(const glm::vec3 &point) {
  const float size = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
  return std::max(1e-3f, size * 4 * std::numeric_limits<float>::epsilon());
}

/// Gives a surface the direction of its neighbourhood, where its rays to the light can begin above it. At the
/// edge of a thing that is seen against the sky, that direction may turn a little away from the eye; the face
/// that was entered tells which side is the outer one then.
void smooth(Surface &surface, const SurfaceNormal &normal, const glm::vec3 &direction) {
  const bool isAlong = glm::dot(normal.direction, surface.normal - glm::normalize(direction)) > 0;
  const float room = isAlong ? normal.roomAlong : normal.roomAgainst;
  if (room == 0)
    return;
  surface.normal = isAlong ? normal.direction : -normal.direction;
  surface.start = surface.point + surface.normal * room;
}

} // namespace

Surface surfaceOf(const Ray &ray, const Hit &hit, const SurfaceNormals *normals) {
  Surface surface;
  const glm::vec3 direction = vectorOf(ray.direction);
  surface.point = vectorOf(ray.origin) + direction * hit.t;
  const EntryFace face = entryFace(ray, hit);
  if (face.axis < 0) {
    surface.normal = -glm::normalize(direction);
    surface.start = surface.point;
    return surface;
  }
  surface.normal[face.axis] = face.high ? 1.0f : -1.0f;
  surface.point[face.axis] = float(hit.voxel[face.axis]) + (face.high ? 1.0f : 0.0f);
  surface.start = surface.point + surface.normal * clearance(surface.point);
  if (normals)
    smooth(surface, normals->at(hit), direction);
  return surface;
}

} // namespace voxc
