// A ray on its way through cells, in float64.
#pragma once

#include "voxc/Support/Geometry.h"
#include "voxc/Trace/Ray.h"

#include <array>

namespace voxc {

/// A cube that is empty: count * 2^log2Side voxels a side, from the aligned cube of 2^log2Side around a voxel
/// on, in a ray's octant.
struct EmptySpan {
  int log2Side = 0;
  int count = 1;
};

class RayPosition {
public:
  /// In the first voxel that the ray has in a volume of `side` voxels on each axis; `isInside` is false if
  /// there is none.
  RayPosition(const Ray &ray, int side);

  /// Steps to the first voxel behind an empty span around this one.
  void leave(const EmptySpan &span);

  Int3 voxel() const { return {cell_[0], cell_[1], cell_[2]}; }
  bool isInside() const { return ((cell_[0] | cell_[1] | cell_[2]) & ~(side_ - 1)) == 0; }
  /// A bit for each coordinate that rises, that of x lowest.
  unsigned octant() const { return octant_; }

private:
  bool rises(std::size_t axis) const { return (octant_ >> axis & 1) != 0; }
  int cellAt(std::size_t axis, double t) const;
  double enter(std::size_t &axis) const;

  int side_;
  unsigned octant_ = 0;
  std::array<double, 3> origin_{};
  std::array<double, 3> direction_{};
  std::array<int, 3> cell_{};
};

/// True if two voxels lie in one aligned cube of 2^height a side.
bool areInOneCube(Int3 a, Int3 b, int height);

/// The height of the smallest aligned cube that holds both.
int commonHeight(Int3 a, Int3 b);

} // namespace voxc
