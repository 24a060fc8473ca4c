// Tracing on a Vulkan device that the program has opened itself. This header and Recorder.h are the only ones
// that need Vulkan's.
#pragma once

#include "voxc/Trace/Tracer.h"

#include <vulkan/vulkan_core.h>

#include <cstdint>

namespace voxc {

/// What kernels may ask of a device beyond plain Vulkan 1.2.
struct HostFeatures {
  VkPhysicalDeviceFeatures core{}; ///< shaderFloat64, shaderInt64 and shaderInt16; others play no part.
  bool bufferDeviceAddress = false;
};

/// A device of the program that asks, which opens and destroys it, and whatever else belongs to it.
struct HostDevice {
  VkInstance instance = VK_NULL_HANDLE; ///< Made for Vulkan 1.2 or later.
  VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  std::uint32_t queueFamily = 0; ///< Of a queue that computes.
  /// For uploads and for `Tracer::trace`, which submit to it and wait: nobody else may use it meanwhile. A
  /// recorder never touches it.
  VkQueue queue = VK_NULL_HANDLE;
  HostFeatures features; ///< Those that the device was opened with.
  /// Of the loader that made the instance; null: the loader that libvulkan.so.1 is.
  PFN_vkGetInstanceProcAddr getInstanceProcAddr = nullptr;
};

/// Those features of a physical device that kernels can make use of: what to open it with. Error
/// (`Environment`): it has no Vulkan 1.2, or the loader is not to be had.
Expected<HostFeatures> usefulFeatures(VkInstance instance, VkPhysicalDevice physicalDevice,
                                      PFN_vkGetInstanceProcAddr getInstanceProcAddr = nullptr);

/// The host's device as one that tracers and recorders are made on. It keeps nothing but what is given about
/// it, and destroys nothing of the host's; the host destroys the device after it. Any number of them may be
/// there, of one device or of several. Errors: a handle is null, or the queue's family does not compute
/// (`Usage`); the device has no Vulkan 1.2, or the loader is not to be had (`Environment`).
Expected<Device> adoptDevice(const HostDevice &host);

} // namespace voxc
