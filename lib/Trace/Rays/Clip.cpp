// Planes beyond which nothing is seen.
#include "voxc/Trace/Clip.h"

#include "Support/ParallelFor.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace voxc {

namespace {

/// The next float32 before a moment.
float justBefore(double moment) {
  constexpr float kMost = std::numeric_limits<float>::max();
  const float nearest = float(std::clamp(moment, -double(kMost), double(kMost)));
  return std::nextafter(nearest, -kMost);
}

glm::dvec3 pointOf(const float (&numbers)[3]) { return {numbers[0], numbers[1], numbers[2]}; }

} // namespace

ClipPlane inVoxels(const ClipPlane &plane, const Transform &voxelToModel) {
  return {glm::transpose(glm::dmat3(voxelToModel)) * plane.normal,
          plane.offset - glm::dot(plane.normal, voxelToModel[3])};
}

void Clip::keepBox(const glm::dvec3 &low, const glm::dvec3 &high) {
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 normal(0);
    normal[axis] = 1;
    planes.push_back({normal, low[axis]});
    planes.push_back({-normal, -high[axis]});
  }
}

RayBounds Clip::boundsOf(const Ray &ray) const {
  const glm::dvec3 origin = pointOf(ray.origin), direction = pointOf(ray.direction);
  // Above 0, at which the voxel is entered in which the ray begins.
  RayBounds bounds{.tmin = std::numeric_limits<float>::min()};
  for (const ClipPlane &plane : planes) {
    const double side = glm::dot(plane.normal, origin) - plane.offset;
    const double speed = glm::dot(plane.normal, direction);
    if (speed > 0)
      bounds.tmin = std::max(bounds.tmin, justBefore(-side / speed));
    else if (speed < 0)
      bounds.tmax = std::min(bounds.tmax, justBefore(-side / speed));
    else if (!(side >= 0))
      bounds.tmax = -1;
  }
  return bounds;
}

Clip::Entry Clip::entryOf(const Ray &ray) const {
  const glm::dvec3 origin = pointOf(ray.origin), direction = pointOf(ray.direction);
  Entry entry;
  for (const ClipPlane &plane : planes) {
    const double speed = glm::dot(plane.normal, direction);
    const double t = (plane.offset - glm::dot(plane.normal, origin)) / speed;
    if (speed > 0 && t > entry.t)
      entry = {&plane, t};
  }
  return entry;
}

std::vector<BoundedRay> Clip::bounded(const RaySpan &rays, unsigned threads) const {
  constexpr std::size_t kAtOnce = 8192;
  std::vector<BoundedRay> all(rays.size());
  parallelFor((rays.size() + kAtOnce - 1) / kAtOnce, threads, [&](std::uint64_t part) {
    const std::size_t end = std::min(rays.size(), (part + 1) * kAtOnce);
    for (std::size_t i = part * kAtOnce; i < end; ++i)
      all[i] = voxc::bounded(rays[i], boundsOf(rays[i]));
  });
  return all;
}

} // namespace voxc
