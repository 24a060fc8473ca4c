// An open device as the back end sees it.
#pragma once

#include "PhysicalDevice.h"

#include <optional>

namespace voxc {

struct Device::State {
  VulkanFunctions vk;
  std::optional<VulkanInstance> instance; ///< Nothing where a host owns it, and the device.
  PhysicalDevice physical;
  VkDevice device = VK_NULL_HANDLE;
  VkQueue queue = VK_NULL_HANDLE;
  const CompileCache *cache = nullptr; ///< Of pipelines, where there is one.

  State(VulkanInstance connection, PhysicalDevice description)
      : vk(connection.functions()), instance(std::move(connection)), physical(std::move(description)) {}
  State(const VulkanFunctions &functions, PhysicalDevice description)
      : vk(functions), physical(std::move(description)) {}
  State(const State &) = delete;
  State &operator=(const State &) = delete;
  ~State() {
    if (instance && device != VK_NULL_HANDLE)
      vk.DestroyDevice(device, nullptr);
  }

  const DeviceInfo &info() const { return physical.info; }
};

} // namespace voxc
