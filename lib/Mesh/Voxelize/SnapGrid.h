// Points in fixed point: what decides which voxels a triangle takes, so that it is decided without rounding.
#pragma once

#include "Mesh/ModelFrame.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace voxc {

using Point64 = std::array<std::int64_t, 3>;

/// A triangle on the grid; its corners may coincide.
struct SnappedTriangle {
  std::array<Point64, 3> corners;

  std::int64_t low(std::size_t axis) const {
    return std::min({corners[0][axis], corners[1][axis], corners[2][axis]});
  }
  std::int64_t high(std::size_t axis) const {
    return std::max({corners[0][axis], corners[1][axis], corners[2][axis]});
  }
};

/// The grid that points of a model are moved to: its steps are 2^-bits of a voxel, and a voxel's corners,
/// face centres and centre lie on it. A point goes to the nearest step, halfway to the even one, so that a
/// model mirrored about a plane between voxels takes the mirrored voxels. There are 12 bits, unless the model
/// reaches so far out of the volume that a coordinate would not stay below 2^39 steps.
class SnapGrid {
public:
  static constexpr int kMostBits = 12;
  static constexpr int kLeastBits = 4;
  static constexpr int kLog2Reach = 39; ///< Differences, and products of three of them, then fit 128 bits.

  /// The grid for a model within `model`. Error: part of it lies 2^35 voxels away, or farther.
  static Expected<SnapGrid> fit(const ModelFrame &frame, const Bounds &model);

  const ModelFrame &frame() const { return frame_; }
  /// log2 of the steps a voxel.
  int bits() const { return bits_; }
  /// A point of the model.
  Point64 snap(const glm::dvec3 &point) const;

private:
  explicit SnapGrid(const ModelFrame &frame) : frame_(frame) {}

  ModelFrame frame_;
  int bits_ = kMostBits;
  double steps_ = 1 << kMostBits; ///< A voxel.
};

} // namespace voxc
