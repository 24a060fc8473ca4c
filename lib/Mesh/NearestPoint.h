// The point of a triangle that is nearest to another point.
#pragma once

#include "Mesh/ModelFrame.h"

#include <array>

namespace voxc {

/// A point of a triangle by its weights at the three vertices, and how far away it is.
struct NearestPoint {
  Double3 weights;
  double distanceSquared;
};

/// The point of the closed triangle nearest to `point`; also of triangles without area.
NearestPoint nearestPoint(const std::array<Double3, 3> &triangle, const Double3 &point);

} // namespace voxc
