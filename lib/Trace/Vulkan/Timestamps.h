// When a stretch of commands began and ended, by the device's own clock.
#pragma once

#include "DeviceState.h"
#include "Handle.h"

#include <cstdint>

namespace voxc {

/// Two timestamps around recorded commands; none on a device that has no clock.
class Timestamps {
public:
  struct Ticks {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
  };

  static Expected<Timestamps> create(Device::State &device);

  void recordBegin(VkCommandBuffer commands) const;
  void recordEnd(VkCommandBuffer commands) const;
  /// The two, once the commands have finished.
  Expected<Ticks> read() const;
  /// Seconds from one tick to another, also over a wrap of the clock.
  static double seconds(const Device::State &device, std::uint64_t begin, std::uint64_t end);

private:
  Timestamps(Device::State &device, QueryPoolHandle queries)
      : device_(&device), queries_(std::move(queries)) {}

  Device::State *device_;
  QueryPoolHandle queries_;
};

} // namespace voxc
