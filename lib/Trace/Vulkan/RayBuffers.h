// What a device needs for the rays of a batch: they themselves, their hits, and a list of those that are left
// over.
#pragma once

#include "Buffer.h"

#include <cstdint>

namespace voxc {

struct RayBuffers {
  Buffer rays;
  Buffer hits;
  Buffer deferred; ///< Of a tile's rays.

  /// For so many rays, with bounds or without, taken by tiles of at most `tileRays`. Error: the device has no
  /// room.
  static Expected<RayBuffers> create(Device::State &device, std::uint64_t rays, bool bounded,
                                     std::uint64_t tileRays);
};

} // namespace voxc
