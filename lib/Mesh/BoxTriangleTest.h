// Does a triangle touch a box? The separating axis theorem, conservative under rounding.
#pragma once

#include "Mesh/ModelFrame.h"

#include <array>

namespace voxc {

/// A box of whole voxels: [low, high) on each axis.
struct VoxelBox {
  Int3 low;
  Int3 high;
};

/// A triangle in voxels, prepared for testing many boxes.
///
/// Any axis on which the shadows of two convex bodies are apart proves them apart, so it does no harm that
/// the axes are rounded: only the shadows' own rounding counts, and the interval of the triangle is widened
/// by it.
class BoxTriangleTest {
public:
  explicit BoxTriangleTest(const std::array<Double3, 3> &triangle);

  /// False only if the closed box and the closed triangle have no point in common.
  bool touches(const VoxelBox &box) const;

private:
  /// An axis, and the interval in which a box's centre lies if a box of no size touches the triangle.
  struct Axis {
    Double3 direction;
    Double3 absolute; ///< Of the direction: half a box's shadow for half its size.
    double low;
    double high;
  };

  void addAxis(const Double3 &direction);

  std::array<Double3, 3> triangle_;
  double error_ = 0; ///< Bound on the rounding of a coordinate, and of a shadow for each unit of direction.
  std::array<Axis, 13> axes_;
  std::size_t axisCount_ = 0;
};

} // namespace voxc
