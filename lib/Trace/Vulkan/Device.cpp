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

bool isNumber(std::string_view text) {
  return !text.empty() && text.size() < 4 &&
         std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c); });
}

/// The hexadecimal digits of a UUID, in lower case; empty if the text is none.
std::string uuidOf(std::string_view text) {
  std::string digits;
  for (const unsigned char c : text)
    if (std::isxdigit(c))
      digits += char(std::tolower(c));
    else if (c != '-')
      return {};
  constexpr std::size_t kDigits = 32;
  return digits.size() == kDigits ? digits : std::string();
}

/// Whether the device at this place is asked for by its number, UUID or name.
bool isCalled(const PhysicalDevice &device, std::size_t place, std::string_view name) {
  if (isNumber(name))
    return name == std::to_string(place);
  if (const std::string uuid = uuidOf(name); !uuid.empty())
    return device.info.uuid == uuid;
  return containsIgnoringCase(device.info.name, name);
}

Error noSuchDevice(std::string_view name, const std::vector<PhysicalDevice> &devices) {
  if (devices.empty())
    return Error::environment("there is no Vulkan device: install a driver, such as Mesa's lavapipe");
  std::string names;
  for (std::size_t i = 0; i < devices.size(); ++i)
    names += (i == 0 ? "" : ", ") + std::to_string(i) + " \"" + devices[i].info.name +
             (devices[i].info.usable ? "\"" : "\" (not usable: no Vulkan 1.2 with compute)");
  std::string wanted = "no usable Vulkan device" +
                       std::string(name.empty()     ? ""
                                   : isNumber(name) ? " of number "
                                                    : " named \"") +
                       std::string(name) + (name.empty() || isNumber(name) ? "" : "\"");
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
  VOXC_TRY(checkThreads(state.info()));
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
  if (VkResult result = state.vk.CreateDevice(state.physical.handle, &info, nullptr, &state.device);
      result != VK_SUCCESS)
    return vulkanError("open " + state.info().name, result);
  state.vk.GetDeviceQueue(state.device, state.physical.queueFamily, 0, &state.queue);
  return {};
}

} // namespace

Device::Device(std::unique_ptr<State> state) : state_(std::move(state)) {}
Device::~Device() = default;
Device::Device(Device &&) noexcept = default;
Device &Device::operator=(Device &&) noexcept = default;

Expected<Device> Device::open(std::string_view name) {
  auto instance = VulkanInstance::create();
  auto devices = instance ? physicalDevices(*instance) : std::vector<PhysicalDevice>{};
  const PhysicalDevice *best = nullptr;
  for (std::size_t i = 0; i < devices.size(); ++i)
    if (devices[i].info.usable && isCalled(devices[i], i, name) && (!best || devices[i].rank < best->rank))
      best = &devices[i];
  if (!best)
    return noSuchDevice(name, devices);
  auto state = std::make_unique<State>(std::move(*instance), *best);
  VOXC_TRY(createDevice(*state));
  return Device(std::move(state));
}

const DeviceInfo &Device::info() const { return state_->info(); }

void Device::useCache(const CompileCache *cache) { state_->cache = cache; }

Addressing Device::addressingFor(std::uint64_t words) const {
  bool fits = VolumeWords::paddedBytes(words) <= info().maxStorageBufferBytes;
  return fits ? Addressing::Buffer : Addressing::Segments;
}

Addressing Device::addressingFor(const Volume &volume) const {
  const std::uint64_t words = volume.words().size();
  // Within trees few rays of a vector are at one height, and those that read nothing are better passed over.
  const bool gains = info().fastTexels && std::ranges::all_of(volume.layout().strata, &Stratum::isGrid);
  const bool fits = VolumeWords::paddedBytes(words) <= info().maxTexelBufferBytes;
  return gains && fits ? Addressing::Texels : addressingFor(words);
}

} // namespace voxc
