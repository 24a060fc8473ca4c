// One command buffer that is recorded, submitted and waited for again and again.
#pragma once

#include "DeviceState.h"
#include "Handle.h"

namespace voxc {

/// Whoever submits must wait before this is destroyed or begun again.
class Commands {
public:
  static Expected<Commands> create(Device::State &device);

  /// Starts recording anew.
  Expected<VkCommandBuffer> begin();
  Expected<void> submit();
  /// Returns when the device is done with everything up to the last submission.
  Expected<void> wait();

private:
  Commands(Device::State &device, CommandPoolHandle pool, FenceHandle fence)
      : device_(&device), pool_(std::move(pool)), fence_(std::move(fence)) {}

  Device::State *device_;
  CommandPoolHandle pool_;
  FenceHandle fence_;
  VkCommandBuffer buffer_ = VK_NULL_HANDLE; ///< Belongs to the pool.
};

/// Makes everything written so far visible to whatever follows, on the device and on the host.
void recordBarrier(const Device::State &device, VkCommandBuffer commands);

} // namespace voxc
