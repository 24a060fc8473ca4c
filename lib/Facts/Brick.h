// A brick of 8^3 voxels that was read, and bits that say which of them are there.
#pragma once

#include "Source/BrickBits.h"
#include "voxc/Support/Geometry.h"

#include <array>
#include <cstdint>

namespace voxc {

struct Brick {
  static constexpr int kLog2Side = 3;
  static constexpr unsigned kVoxels = 512;

  Int3 low;
  std::array<std::uint32_t, kVoxels> words; ///< In Morton order.
  MortonBits masks;                         ///< Which words are not 0.
  Slices slices;                            ///< The same bits by coordinates.

  /// Makes `masks` and `slices` of `words`. False if there is no voxel; then `slices` are not made.
  bool findBits();
  /// The bits of the voxels in the i-th cube of 2^3, 0 to 63, in Morton order.
  std::uint32_t octet(unsigned i) const {
    return static_cast<std::uint32_t>(masks[i / 8] >> 8 * (i % 8) & 0xff);
  }
};

} // namespace voxc
