// Choosing among keys, and between two of them.
#include "Input/MagicaVoxel/VoxKeys.h"

#include <algorithm>

namespace voxc {

namespace {

/// The time from the first to the last of `keys` that is shown at `frame`.
std::int64_t loopedTime(const std::vector<VoxKey> &keys, std::int64_t frame) {
  const std::int64_t first = keys.front().time;
  const std::int64_t length = keys.back().time - first + 1;
  const std::int64_t past = (frame - first) % length;
  return first + (past < 0 ? past + length : past);
}

/// Rounded towards 0, as other readers do. Places and times of 32 bits keep the sum within 64.
Long3 between(const VoxKey &key, const VoxKey &next, std::int64_t time) {
  const std::int64_t all = next.time - key.time;
  const std::int64_t part = time - key.time;
  Long3 place;
  for (std::size_t axis = 0; axis < 3; ++axis)
    place[axis] = (key.translation[axis] * (all - part) + next.translation[axis] * part) / all;
  return place;
}

} // namespace

VoxKey keyAt(std::vector<VoxKey> keys, bool loop, std::int32_t frame) {
  if (keys.empty())
    return {};
  std::ranges::stable_sort(keys, {}, &VoxKey::time);
  const auto twice = std::ranges::unique(keys, {}, &VoxKey::time);
  keys.erase(twice.begin(), twice.end());
  const std::int64_t time = loop ? loopedTime(keys, frame) : frame;
  const auto next = std::ranges::upper_bound(keys, time, {}, &VoxKey::time);
  if (next == keys.begin())
    return keys.front();
  VoxKey key = *(next - 1);
  if (next != keys.end())
    key.translation = between(key, *next, time);
  return key;
}

std::int32_t framesOf(const std::vector<VoxKey> &keys) {
  if (keys.size() < 2)
    return 1;
  const std::int64_t last = std::ranges::max_element(keys, {}, &VoxKey::time)->time;
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(last + 1, 1, kMostVoxFrames));
}

} // namespace voxc
