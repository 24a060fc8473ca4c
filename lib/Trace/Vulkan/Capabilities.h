// What kernels may ask of a device beyond plain Vulkan 1.2.
#pragma once

#include "PhysicalDevice.h"

#include "voxc/Trace/Kernel.h"

#include <cstdint>
#include <string_view>

namespace voxc {

/// Those of the available features that kernels may use: a device is opened with them.
VkPhysicalDeviceFeatures kernelFeatures(const VkPhysicalDeviceFeatures &available);

/// Whether every device has this capability of SPIR-V.
bool isEverywhere(std::uint32_t capability);

/// The feature of Vulkan that a capability of SPIR-V follows from, by its name; empty if it is none of those.
std::string_view featureOf(std::uint32_t capability);

/// Checks that a kernel runs right on an open device. Errors: it relies on loops or arithmetic that the
/// device is not known for (`Input`), or on a capability that it lacks (`Environment`).
Expected<void> checkKernel(const PhysicalDevice &device, const Kernel &kernel);

} // namespace voxc
