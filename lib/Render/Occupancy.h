// Which voxels around a place are not empty, read once a brick.
#pragma once

#include "voxc/Volume/ShapeReader.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace voxc {

/// How far a neighbourhood reaches from its middle voxel, and its voxels on an axis.
inline constexpr int kReach = 4;
inline constexpr int kNeighbours = 2 * kReach + 1;

/// A cube of voxels around one: row y + 9 z has a bit for each x, the lowest first.
using Neighbourhood = std::array<std::uint16_t, kNeighbours * kNeighbours>;

/// Whether the voxel at an offset from the middle, at most `kReach` on each axis, is empty.
inline bool isEmpty(const Neighbourhood &voxels, Int3 offset) {
  const std::size_t row = std::size_t(offset.y + kReach + kNeighbours * (offset.z + kReach));
  return (voxels[row] >> (offset.x + kReach) & 1) == 0;
}

/// Reads a volume by bricks of 4^3 voxels and keeps them. For one thread.
class Occupancy {
public:
  explicit Occupancy(ShapeReader reader) : reader_(std::move(reader)) {}

  const ShapeReader &reader() const { return reader_; }

  /// The voxels around `middle`; those outside of the volume are empty.
  Neighbourhood around(Int3 middle);

private:
  /// Bit x + 4 y + 16 z: that voxel of the brick is not empty.
  std::uint64_t brick(Int3 at);
  std::uint64_t readBrick(Int3 at) const;

  ShapeReader reader_;
  std::unordered_map<std::uint64_t, std::uint64_t> bricks_; ///< By the Morton code of their place.
};

} // namespace voxc
