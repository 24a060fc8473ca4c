// What of a volume is looked at: planes beyond which nothing is seen.
#pragma once

#include "voxc/Support/Transform.h"
#include "voxc/Trace/BoundedRay.h"

#include <glm/vec3.hpp>

#include <vector>

namespace voxc {

/// A plane that cuts away the points p with dot(normal, p) < offset. The normal is of any length but 0.
struct ClipPlane {
  glm::dvec3 normal{};
  double offset = 0;

  bool operator==(const ClipPlane &) const = default;
};

/// The plane of the units of a model as one in voxels.
ClipPlane inVoxels(const ClipPlane &plane, const Transform &voxelToModel);

/// The points that no plane cuts away; without planes all.
///
/// It is seen by rays with bounds: a ray that enters a voxel at a point that is cut away does not see that
/// voxel, but the first that it enters at a point that is kept, so that inner voxels show at the cut. The
/// voxel in which a ray begins is cut away as well. Voxels and their t are exact, as ever; the bounds are
/// those of the planes, rounded to float32: by one place towards the ray's origin, so that faces that lie in
/// a plane are seen from its kept side and not from the other.
struct Clip {
  std::vector<ClipPlane> planes;

  bool cutsNothing() const { return planes.empty(); }
  /// Keeps what lies between two corners.
  void keepBox(const glm::dvec3 &low, const glm::dvec3 &high);

  /// Where a ray goes through what is kept; empty if nowhere.
  RayBounds boundsOf(const Ray &ray) const;
  /// The plane through which a ray enters what is kept, and when; null, and 0, if it begins there or never
  /// enters it.
  struct Entry {
    const ClipPlane *plane = nullptr;
    double t = 0;
  };
  Entry entryOf(const Ray &ray) const;
  /// Rays with these bounds, on so many threads; 0: as many as the machine has. Bounds that they have are
  /// left out.
  std::vector<BoundedRay> bounded(const RaySpan &rays, unsigned threads) const;

  bool operator==(const Clip &) const = default;
};

} // namespace voxc
