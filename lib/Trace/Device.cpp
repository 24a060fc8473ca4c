// Choosing a device and opening it.
#include "Capabilities.h"
#include "DeviceState.h"
#include "VolumeWords.h"
#include "VulkanError.h"

#include "Support/ParallelFor.h"

#include <algorithm>
#include <cctype>

namespace voxc {
namespace {

bool containsIgnoringCase(std::string_view text, std::string_view part) {
  auto equal = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
  return part.empty() || !std::ranges::search(text, part, equal).empty();
}

Error noSuchDevice(std::string_view name, const std::vector<PhysicalDevice> &devices) {
  if (devices.empty())
    return Error::environment("there is no Vulkan device: install a driver, such as Mesa's lavapipe");
  std::string names;
  for (const PhysicalDevice &device : devices)
    names += (names.empty() ? "\"" : ", \"") + device.info.name +
             (device.info.usable ? "\"" : "\" (not usable: no Vulkan 1.2 with compute)");
  std::string wanted = name.empty() ? "no usable Vulkan device"
                                    : "no usable Vulkan device named \"" + std::string(name) + "\"";
  return Error::environment("there is " + wanted + "; there are: " + names);
}

/// Mesa's drivers that run on the processor start a thread a core and some more when a device is opened, and
/// wait for ever for those that they do not get.
Expected<void> checkThreads(const DeviceInfo &info) {
  constexpr unsigned kMostOfRasterizer = 32;
  constexpr unsigned kOthers = 4;
  const unsigned needed = std::min(threadsOrAll(0), kMostOfRasterizer) + kOthers;
  if (info.kind != "cpu" || canStartThreads(needed))
    return {};
  return Error::environment("cannot start the " + std::to_string(needed) + " threads that " + info.name +
                            " may need; raise the limit on threads, or use --device cpu");
}

Expected<void> createDevice(Device::State &state) {
  if (auto checked = checkThreads(state.info()); !checked)
    return checked;
  float priority = 1;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = state.physical.queueFamily;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkPhysicalDeviceBufferDeviceAddressFeatures addresses{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_BUFFER_DEVICE_ADDRESS_FEATURES};
  addresses.bufferDeviceAddress = state.info().deviceAddresses;
  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
  info.pNext = &addresses;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  state.physical.features = kernelFeatures(state.physical.features);
  info.pEnabledFeatures = &state.physical.features;
  if (VkResult result = vkCreateDevice(state.physical.handle, &info, nullptr, &state.device);
      result != VK_SUCCESS)
    return vulkanError("open " + state.info().name, result);
  vkGetDeviceQueue(state.device, state.physical.queueFamily, 0, &state.queue);
  return {};
}

} // namespace

Device::Device(std::unique_ptr<State> state) : state_(std::move(state)) {}
Device::~Device() = default;
Device::Device(Device &&) noexcept = default;
Device &Device::operator=(Device &&) noexcept = default;

Expected<Device> Device::open(std::string_view name) {
  auto instance = Instance::create();
  auto devices = instance ? physicalDevices(*instance) : std::vector<PhysicalDevice>{};
  const PhysicalDevice *best = nullptr;
  for (const PhysicalDevice &device : devices)
    if (device.info.usable && containsIgnoringCase(device.info.name, name) &&
        (!best || device.rank < best->rank))
      best = &device;
  if (!best)
    return noSuchDevice(name, devices);
  auto state = std::make_unique<State>(std::move(*instance), *best);
  if (auto created = createDevice(*state); !created)
    return created.error();
  return Device(std::move(state));
}

const DeviceInfo &Device::info() const { return state_->info(); }

Addressing Device::addressingFor(std::uint64_t words) const {
  bool fits = VolumeWords::paddedBytes(words) <= info().maxStorageBufferBytes;
  return fits ? Addressing::Buffer : Addressing::Segments;
}

} // namespace voxc
