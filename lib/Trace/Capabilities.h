// What kernels may ask of a device beyond plain Vulkan 1.2.
#pragma once

#include "PhysicalDevice.h"

#include "voxc/Trace/Kernel.h"

#include <cstdint>
#include <span>

namespace voxc {

/// Those of the available features that kernels may use: a device is opened with them.
VkPhysicalDeviceFeatures kernelFeatures(const VkPhysicalDeviceFeatures &available);

/// Checks that an open device has every capability that a module declares. Error: `Environment`, naming it.
Expected<void> checkCapabilities(const PhysicalDevice &device, std::span<const std::uint32_t> spirv);

/// Checks all that a kernel is made for: loops, arithmetic and capabilities. Errors: `Input`, another kernel
/// is needed; `Environment`.
Expected<void> checkDevice(const PhysicalDevice &device, const Kernel &kernel);

} // namespace voxc
