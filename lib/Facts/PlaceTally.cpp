// The box around voxels and their regions, from the bits of bricks.
#include "PlaceTally.h"

#include <algorithm>
#include <array>
#include <bit>

namespace voxc {

namespace {

/// For each axis, the coordinates in a brick at which there are voxels: a bit each.
std::array<unsigned, 3> shadows(const Slices &slices) {
  std::uint64_t all = 0;
  std::array<unsigned, 3> shadows{};
  for (unsigned z = 0; z < 8; ++z) {
    all |= slices[z];
    shadows[2] |= unsigned{slices[z] != 0} << z;
  }
  for (unsigned y = 0; y < 8; ++y) {
    const auto row = static_cast<unsigned>(all >> 8 * y & 0xff);
    shadows[0] |= row;
    shadows[1] |= unsigned{row != 0} << y;
  }
  return shadows;
}

} // namespace

PlaceTally::PlaceTally(int log2Extent) { regions_.log2Side = std::max(2, log2Extent) - 2; }

void PlaceTally::add(const Brick &brick) {
  extendBox(brick);
  if (regions_.log2Side >= Brick::kLog2Side) {
    std::uint64_t &region = regionOf(brick.low);
    for (const std::uint64_t mask : brick.masks)
      region += static_cast<std::uint64_t>(std::popcount(mask));
    return;
  }
  for (unsigned i = 0; i < Brick::kVoxels; ++i)
    if (brick.words[i] != 0)
      ++regionOf(brick.low + mortonCell(i));
}

void PlaceTally::extendBox(const Brick &brick) {
  const std::array<unsigned, 3> shadows = voxc::shadows(brick.slices);
  for (int axis = 0; axis < 3; ++axis) {
    const unsigned shadow = shadows[static_cast<unsigned>(axis)];
    const std::int32_t low = brick.low[axis] + std::countr_zero(shadow);
    const std::int32_t high = brick.low[axis] + static_cast<std::int32_t>(std::bit_width(shadow));
    low_[axis] = isEmpty_ ? low : std::min(low_[axis], low);
    high_[axis] = isEmpty_ ? high : std::max(high_[axis], high);
  }
  isEmpty_ = false;
}

std::uint64_t &PlaceTally::regionOf(Int3 cell) {
  const Int3 region = cell >> regions_.log2Side;
  return regions_.voxels[static_cast<std::size_t>(region.x + 4 * (region.y + 4 * region.z))];
}

} // namespace voxc
