// An open device as the back end sees it.
#pragma once

#include "PhysicalDevice.h"

namespace voxc {

struct Device::State {
  Instance instance;
  PhysicalDevice physical;
  VkDevice device = VK_NULL_HANDLE;
  VkQueue queue = VK_NULL_HANDLE;

  State(Instance connection, PhysicalDevice description)
      : instance(std::move(connection)), physical(std::move(description)) {}
  State(const State &) = delete;
  State &operator=(const State &) = delete;
  ~State() {
    if (device != VK_NULL_HANDLE)
      vkDestroyDevice(device, nullptr);
  }

  const DeviceInfo &info() const { return physical.info; }
};

} // namespace voxc
