// What Vulkan says of each device before one is opened.
#pragma once

#include "VulkanInstance.h"

#include "voxc/Trace/Tracer.h"

#include <vector>

namespace voxc {

/// A device that could be opened, with everything that opening it needs.
struct PhysicalDevice {
  VkPhysicalDevice handle = VK_NULL_HANDLE;
  DeviceInfo info;
  VkPhysicalDeviceLimits limits{};
  VkPhysicalDeviceFeatures features{};
  VkPhysicalDeviceMemoryProperties memory{};
  std::uint32_t queueFamily = 0;   ///< A family that computes, if the device is usable.
  std::uint32_t timestampBits = 0; ///< Valid bits of its timestamps; 0 if it has none.
  bool roundsToNearest = false;    ///< Sums and products of float32, where a kernel asks for it.
  int rank = 0;                    ///< Of its kind; the best is 0.
};

std::vector<VkQueueFamilyProperties> queueFamilies(const VulkanFunctions &vk, VkPhysicalDevice device);

/// What kernels may rely on where the device counts with float32 alone.
Arithmetic withoutDoubles(const PhysicalDevice &device);

/// What these functions say of a device.
PhysicalDevice describe(const VulkanFunctions &vk, VkPhysicalDevice handle);

/// The devices of this machine in the driver's order.
std::vector<PhysicalDevice> physicalDevices(const VulkanInstance &instance);

} // namespace voxc
