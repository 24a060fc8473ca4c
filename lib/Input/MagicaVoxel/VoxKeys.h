// The keys of MagicaVoxel's animations.
#pragma once

#include "Input/MagicaVoxel/Placement.h"

#include <cstdint>
#include <vector>

namespace voxc {

/// As many as are looked at.
inline constexpr std::uint32_t kMostVoxFrames = 1 << 20;

/// What a node says of a time: where it is, or which model it shows.
struct VoxKey {
  std::int64_t time = 0; ///< Of 32 bits, as are places.
  unsigned rotation = 4; ///< No rotation.
  Long3 translation{};
  std::uint32_t model = 0;
};

/// What a node is at the time `frame`: the last key up to it, else the first, moved in a straight line
/// towards the next, in whole cells. Keys that `loop` repeat, from the first to the last. They may come in
/// any order; of two at one time the first counts.
VoxKey keyAt(std::vector<VoxKey> keys, bool loop, std::int32_t frame);

/// One more than the time of the last key. A node of one key stays where it is, in one frame.
std::int32_t framesOf(const std::vector<VoxKey> &keys);

} // namespace voxc
