// Tracing on a Vulkan device that the program has opened itself.
#include "voxc/Trace/HostDevice.h"

#include "Capabilities.h"
#include "DeviceState.h"

#include "Support/Platform/Library.h"

#include <string>

namespace voxc {
namespace {

Expected<VulkanFunctions> hostFunctions(VkInstance instance, PFN_vkGetInstanceProcAddr getInstanceProcAddr) {
  if (!getInstanceProcAddr) {
    if (const VulkanLoader *loader = loadVulkan())
      return loader->functions;
    return Error::environment("there is no " + std::string(platform::kVulkanLoader) +
                              " of Vulkan 1.2 or later");
  }
  if (auto functions = functionsOf(instance, getInstanceProcAddr))
    return *functions;
  return Error::environment("the host's Vulkan lacks functions of Vulkan 1.2: its instance must be made for "
                            "that version or a later one");
}

Error tooOld(const PhysicalDevice &device) {
  return Error::environment(device.info.name + " has Vulkan " + device.info.apiVersion +
                            "; voxc needs 1.2 and a queue that computes");
}

/// A null handle among those of a host; empty if there is none.
std::string_view missingHandle(const HostDevice &host) {
  return host.instance == VK_NULL_HANDLE         ? "instance"
         : host.physicalDevice == VK_NULL_HANDLE ? "physical device"
         : host.device == VK_NULL_HANDLE         ? "device"
         : host.queue == VK_NULL_HANDLE          ? "queue"
                                                 : "";
}

/// Takes the host's queue in place of the one that voxc would choose.
Expected<void> useQueue(const VulkanFunctions &vk, PhysicalDevice &device, std::uint32_t family) {
  const auto families = queueFamilies(vk, device.handle);
  if (family >= families.size() || !(families[family].queueFlags & VK_QUEUE_COMPUTE_BIT))
    return Error::usage("queue family " + std::to_string(family) + " of " + device.info.name +
                        " does not compute");
  device.queueFamily = family;
  device.timestampBits = families[family].timestampValidBits;
  return {};
}

/// Takes what the device was opened with in place of what it could have been.
void useFeatures(PhysicalDevice &device, const HostFeatures &features) {
  device.features = features.core;
  device.info.deviceAddresses = features.bufferDeviceAddress;
  if (!features.core.shaderFloat64)
    device.info.arithmetic = withoutDoubles(device);
}

} // namespace

Expected<HostFeatures> usefulFeatures(VkInstance instance, VkPhysicalDevice physicalDevice,
                                      PFN_vkGetInstanceProcAddr getInstanceProcAddr) {
  auto functions = VOXC_TRY(hostFunctions(instance, getInstanceProcAddr));
  const PhysicalDevice device = describe(functions, physicalDevice);
  if (!device.info.usable)
    return tooOld(device);
  return HostFeatures{kernelFeatures(device.features), device.info.deviceAddresses};
}

Expected<Device> adoptDevice(const HostDevice &host) {
  if (const auto missing = missingHandle(host); !missing.empty())
    return Error::usage("the host's " + std::string(missing) + " is VK_NULL_HANDLE");
  auto functions = VOXC_TRY(hostFunctions(host.instance, host.getInstanceProcAddr));
  auto state = std::make_unique<Device::State>(functions, describe(functions, host.physicalDevice));
  if (!state->info().usable)
    return tooOld(state->physical);
  VOXC_TRY(useQueue(functions, state->physical, host.queueFamily));
  useFeatures(state->physical, host.features);
  state->device = host.device;
  state->queue = host.queue;
  return Device(std::move(state));
}

} // namespace voxc
