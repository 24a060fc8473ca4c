// What Vulkan says of each device before one is opened.
#include "PhysicalDevice.h"

#include <algorithm>
#include <iterator>

namespace voxc {
namespace {

struct DeviceKind {
  VkPhysicalDeviceType type;
  std::string_view name;
};

/// From the best kind to the worst.
constexpr DeviceKind kDeviceKinds[] = {
    {VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU, "discrete gpu"},
    {VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU, "integrated gpu"},
    {VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU, "virtual gpu"},
    {VK_PHYSICAL_DEVICE_TYPE_CPU, "cpu"},
    {VK_PHYSICAL_DEVICE_TYPE_OTHER, "other"},
};

std::string versionText(std::uint32_t version) {
  return std::to_string(VK_API_VERSION_MAJOR(version)) + "." + std::to_string(VK_API_VERSION_MINOR(version)) +
         "." + std::to_string(VK_API_VERSION_PATCH(version));
}

bool findQueueFamily(const VulkanFunctions &vk, PhysicalDevice &device) {
  const std::vector<VkQueueFamilyProperties> families = queueFamilies(vk, device.handle);
  for (std::uint32_t family = 0; family < families.size(); ++family) {
    if (!(families[family].queueFlags & VK_QUEUE_COMPUTE_BIT))
      continue;
    device.queueFamily = family;
    device.timestampBits = families[family].timestampValidBits;
    return true;
  }
  return false;
}

void describeKind(PhysicalDevice &device, VkPhysicalDeviceType type) {
  const auto *row = std::ranges::find(kDeviceKinds, type, &DeviceKind::type);
  device.rank = static_cast<int>(row - kDeviceKinds);
  device.info.kind = row == std::end(kDeviceKinds) ? "other" : row->name;
}

void describeMemory(const VulkanFunctions &vk, PhysicalDevice &device) {
  vk.GetPhysicalDeviceMemoryProperties(device.handle, &device.memory);
  for (std::uint32_t heap = 0; heap < device.memory.memoryHeapCount; ++heap)
    device.info.memoryBytes =
        std::max<std::uint64_t>(device.info.memoryBytes, device.memory.memoryHeaps[heap].size);
}

/// What only a device of Vulkan 1.2 answers.
std::string hexadecimal(const std::uint8_t (&bytes)[VK_UUID_SIZE]) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes)
    text += {kDigits[byte >> 4], kDigits[byte & 15]};
  return text;
}

void describeVersion12(const VulkanFunctions &vk, PhysicalDevice &device) {
  VkPhysicalDeviceMaintenance3Properties maintenance{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES};
  VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
  driver.pNext = &maintenance;
  VkPhysicalDeviceIDProperties identity{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ID_PROPERTIES};
  identity.pNext = &driver;
  VkPhysicalDeviceFloatControlsProperties floats{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FLOAT_CONTROLS_PROPERTIES};
  floats.pNext = &identity;
  VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
  properties.pNext = &floats;
  vk.GetPhysicalDeviceProperties2(device.handle, &properties);
  device.info.uuid = hexadecimal(identity.deviceUUID);
  device.info.fastTexels = driver.driverID == VK_DRIVER_ID_MESA_LLVMPIPE;
  device.info.loops = driver.driverID == VK_DRIVER_ID_MESA_LLVMPIPE ? Loops::Cut : Loops::Whole;
  device.info.driver = std::string(driver.driverName) + " " + driver.driverInfo;
  device.info.maxAllocationBytes = maintenance.maxMemoryAllocationSize;

  VkPhysicalDeviceBufferDeviceAddressFeatures addresses{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_BUFFER_DEVICE_ADDRESS_FEATURES};
  VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  features.pNext = &addresses;
  vk.GetPhysicalDeviceFeatures2(device.handle, &features);
  device.features = features.features;
  device.roundsToNearest = floats.shaderRoundingModeRTEFloat32;
  device.info.arithmetic = withoutDoubles(device);
  // Of no other driver do we know that its inverse is rounded to nearest. Kernels that do not step in doubles
  // ask for that rounding.
  if (driver.driverID == VK_DRIVER_ID_MESA_LLVMPIPE && device.features.shaderFloat64 &&
      device.roundsToNearest)
    device.info.arithmetic = Arithmetic::Ieee;
  device.info.deviceAddresses = addresses.bufferDeviceAddress;
}

} // namespace

Arithmetic withoutDoubles(const PhysicalDevice &device) {
  return device.roundsToNearest ? Arithmetic::Nearest : Arithmetic::Any;
}

std::vector<VkQueueFamilyProperties> queueFamilies(const VulkanFunctions &vk, VkPhysicalDevice device) {
  std::uint32_t count = 0;
  vk.GetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vk.GetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  return families;
}

PhysicalDevice describe(const VulkanFunctions &vk, VkPhysicalDevice handle) {
  PhysicalDevice device{.handle = handle};
  VkPhysicalDeviceProperties properties{};
  vk.GetPhysicalDeviceProperties(handle, &properties);
  device.limits = properties.limits;
  device.info.name = properties.deviceName;
  device.info.apiVersion = versionText(properties.apiVersion);
  device.info.maxStorageBufferBytes = properties.limits.maxStorageBufferRange;
  device.info.maxTexelBufferBytes = std::uint64_t{4} * properties.limits.maxTexelBufferElements;
  describeKind(device, properties.deviceType);
  describeMemory(vk, device);
  bool computes = findQueueFamily(vk, device);
  if (properties.apiVersion >= VK_API_VERSION_1_2) {
    describeVersion12(vk, device);
    device.info.usable = computes;
  }
  return device;
}

std::vector<PhysicalDevice> physicalDevices(const VulkanInstance &instance) {
  const VulkanFunctions &vk = instance.functions();
  std::uint32_t count = 0;
  if (vk.EnumeratePhysicalDevices(instance.get(), &count, nullptr) != VK_SUCCESS)
    return {};
  std::vector<VkPhysicalDevice> handles(count);
  // VK_INCOMPLETE can only mean that a device was plugged in meanwhile.
  if (vk.EnumeratePhysicalDevices(instance.get(), &count, handles.data()) < VK_SUCCESS)
    return {};
  handles.resize(count);
  std::vector<PhysicalDevice> devices;
  std::ranges::transform(handles, std::back_inserter(devices),
                         [&](VkPhysicalDevice handle) { return describe(vk, handle); });
  return devices;
}

std::vector<DeviceInfo> listDevices() {
  auto instance = VulkanInstance::create();
  if (!instance)
    return {};
  std::vector<DeviceInfo> infos;
  for (PhysicalDevice &device : physicalDevices(*instance))
    infos.push_back(std::move(device.info));
  return infos;
}

} // namespace voxc
