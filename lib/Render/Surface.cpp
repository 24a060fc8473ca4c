// Surfaces of hits.
#include "Surface.h"

#include "Trace/Rays/EntryFace.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace voxc {

namespace {

/// So many voxels above a cut rays to the light begin.
constexpr float kAboveCut = 0.01f;

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

/// The surface, or that of a cut, if the voxel lies right behind it: the first that a ray enters in the thing
/// that is cut is up to a voxel further on than the plane, and from there light would not come out.
Surface cutSurface(const Ray &ray, const Hit &hit, const Surface &surface, const glm::vec3 &spacing,
                   const Clip &clip) {
  const Clip::Entry entry = clip.entryOf(ray);
  if (!entry.plane || double(hit.t) - entry.t > double(glm::length(spacing)))
    return surface;
  Surface cut;
  // Divided by its largest part first: what is very long or short has a length that is no float.
  const glm::dvec3 &normal = entry.plane->normal;
  const double largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  const glm::vec3 towardsEye(-glm::normalize(normal / largest));
  const glm::vec3 point = vectorOf(ray.origin) + vectorOf(ray.direction) * float(entry.t);
  cut.point = point * spacing;
  cut.normal = glm::normalize(towardsEye / spacing);
  cut.start = point + towardsEye * kAboveCut;
  return cut;
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

// A plane that is stretched faces where it is not stretched.
Surface spacedSurface(const Ray &ray, const Hit &hit, const SurfaceNormals *normals, const glm::vec3 &spacing,
                      const Clip *clip) {
  Surface surface = surfaceOf(ray, hit, normals);
  surface.normal = glm::normalize(surface.normal / spacing);
  surface.point *= spacing;
  return clip ? cutSurface(ray, hit, surface, spacing, *clip) : surface;
}

} // namespace voxc
