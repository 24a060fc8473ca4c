// Opening a device.
#include "GpuState.h"

#include <algorithm>
#include <cctype>
#include <cstring>

namespace voxc::gpu {
namespace {

struct ResultName {
  VkResult result;
  const char *name;
};
constexpr ResultName kResultNames[] = {
    {VK_ERROR_OUT_OF_HOST_MEMORY, "the machine is short of memory"},
    {VK_ERROR_OUT_OF_DEVICE_MEMORY, "it is short of memory"},
    {VK_ERROR_DEVICE_LOST, "it is lost"},
    {VK_ERROR_INCOMPATIBLE_DRIVER, "there is no driver"},
    {VK_ERROR_FEATURE_NOT_PRESENT, "it lacks a feature"},
};

bool contains(std::string_view text, std::string_view part) {
  const auto equal = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
  return part.empty() || !std::ranges::search(text, part, equal).empty();
}

Expected<void> makeInstance(Gpu::State &state) {
  VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.apiVersion = VK_API_VERSION_1_2;
  VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &application;
  if (const VkResult result = vkCreateInstance(&info, nullptr, &state.instance); result != VK_SUCCESS)
    return gpuError("be reached", result);
  return {};
}

Expected<void> choose(Gpu::State &state, std::string_view name) {
  std::uint32_t count = 0;
  vkEnumeratePhysicalDevices(state.instance, &count, nullptr);
  std::vector<VkPhysicalDevice> devices(count);
  vkEnumeratePhysicalDevices(state.instance, &count, devices.data());
  for (const bool processors : {false, true})
    for (const VkPhysicalDevice device : devices) {
      VkPhysicalDeviceFloatControlsProperties floats{
          VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FLOAT_CONTROLS_PROPERTIES};
      VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES, &floats};
      VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &driver};
      vkGetPhysicalDeviceProperties2(device, &properties);
      const VkPhysicalDeviceProperties &of = properties.properties;
      if ((of.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU) != processors || !contains(of.deviceName, name))
        continue;
      state.physical = device;
      state.secondsOfTick = double(of.limits.timestampPeriod) * 1e-9;
      state.facts = {.name = of.deviceName,
                     .driver = std::string(driver.driverName) + " " + driver.driverInfo,
                     .api = std::to_string(VK_API_VERSION_MAJOR(of.apiVersion)) + "." +
                            std::to_string(VK_API_VERSION_MINOR(of.apiVersion)) + "." +
                            std::to_string(VK_API_VERSION_PATCH(of.apiVersion)),
                     .isProcessor = processors,
                     .roundsToNearest = floats.shaderRoundingModeRTEFloat32 != VK_FALSE,
                     .mostGroups = of.limits.maxComputeWorkGroupCount[0],
                     .mostInGroup = std::min(of.limits.maxComputeWorkGroupSize[0],
                                             of.limits.maxComputeWorkGroupInvocations),
                     .mostStorageBytes = of.limits.maxStorageBufferRange};
      vkGetPhysicalDeviceMemoryProperties(device, &state.memory);
      for (std::uint32_t heap = 0; heap < state.memory.memoryHeapCount; ++heap)
        if (state.memory.memoryHeaps[heap].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT)
          state.facts.memoryBytes = std::max(state.facts.memoryBytes, state.memory.memoryHeaps[heap].size);
      return {};
    }
  return Error::environment("there is no Vulkan device whose name has '" + std::string(name) + "'");
}

bool hasExtension(VkPhysicalDevice device, const char *name) {
  std::uint32_t count = 0;
  vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data());
  return std::ranges::any_of(extensions, [&](const VkExtensionProperties &extension) {
    return std::strcmp(extension.extensionName, name) == 0;
  });
}

std::uint32_t computeFamily(VkPhysicalDevice device) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  const auto family = std::ranges::find_if(
      families, [](const VkQueueFamilyProperties &of) { return of.queueFlags & VK_QUEUE_COMPUTE_BIT; });
  return static_cast<std::uint32_t>(family - families.begin());
}

/// With the features of kernels that it has.
Expected<void> makeDevice(Gpu::State &state) {
  state.family = computeFamily(state.physical);
  state.facts.hasStatistics =
      hasExtension(state.physical, VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME);
  VkPhysicalDeviceFeatures has{};
  vkGetPhysicalDeviceFeatures(state.physical, &has);
  VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR executables{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR};
  executables.pipelineExecutableInfo = VK_TRUE;
  VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  features.pNext = state.facts.hasStatistics ? &executables : nullptr;
  features.features.shaderInt64 = has.shaderInt64;
  features.features.shaderFloat64 = has.shaderFloat64;
  features.features.shaderInt16 = has.shaderInt16;
  const float priority = 1;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = state.family;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  const char *const extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &features};
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = state.facts.hasStatistics;
  info.ppEnabledExtensionNames = &extension;
  if (const VkResult result = vkCreateDevice(state.physical, &info, nullptr, &state.device);
      result != VK_SUCCESS)
    return gpuError("be opened", result);
  vkGetDeviceQueue(state.device, state.family, 0, &state.queue);
  return {};
}

/// What records and times commands.
Expected<void> makeCommands(Gpu::State &state) {
  constexpr const char *kVerb = "make its commands";
  VkCommandPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  poolInfo.queueFamilyIndex = state.family;
  state.pool = VOXC_TRY(make<OwnedCommandPool>(state.device, vkCreateCommandPool, poolInfo, kVerb));
  VkCommandBufferAllocateInfo commands{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  commands.commandPool = state.pool.get();
  commands.commandBufferCount = 1;
  if (const VkResult result = vkAllocateCommandBuffers(state.device, &commands, &state.commands);
      result != VK_SUCCESS)
    return gpuError(kVerb, result);
  state.fence = VOXC_TRY(make<OwnedFence>(state.device, vkCreateFence,
                                          VkFenceCreateInfo{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO}, kVerb));
  VkQueryPoolCreateInfo queriesInfo{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
  queriesInfo.queryType = VK_QUERY_TYPE_TIMESTAMP;
  queriesInfo.queryCount = kMostSteps + 1;
  state.queries = VOXC_TRY(make<OwnedQueries>(state.device, vkCreateQueryPool, queriesInfo, kVerb));
  return {};
}

Expected<void> makeStaging(Gpu::State &state) {
  state.staging = VOXC_TRY(makeBuffer(
      state, kStagingBytes, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT));
  void *mapped = nullptr;
  if (const VkResult result =
          vkMapMemory(state.device, state.staging.memory.get(), 0, VK_WHOLE_SIZE, 0, &mapped);
      result != VK_SUCCESS)
    return gpuError("share memory", result);
  state.staged = static_cast<std::byte *>(mapped);
  return {};
}

} // namespace

Gpu::State::~State() {
  queries = {}, fence = {}, pool = {}, staging = {};
  if (device)
    vkDestroyDevice(device, nullptr);
  if (instance)
    vkDestroyInstance(instance, nullptr);
}

Gpu::Gpu(std::unique_ptr<State> state) : state_(std::move(state)) {}
Gpu::Gpu(Gpu &&) noexcept = default;
Gpu::~Gpu() = default;

const GpuFacts &Gpu::facts() const { return state_->facts; }

Error gpuError(const char *verb, VkResult result) {
  const auto *const row = std::ranges::find(kResultNames, result, &ResultName::result);
  return Error::environment(
      std::string("the device cannot ") + verb + ": " +
      (row == std::end(kResultNames) ? "Vulkan returned " + std::to_string(result) : row->name));
}

Expected<Gpu> Gpu::open(std::string_view name) {
  auto state = std::make_unique<State>();
  VOXC_TRY(makeInstance(*state));
  VOXC_TRY(choose(*state, name));
  for (Expected<void> (*const make)(State &) : {makeDevice, makeCommands, makeStaging})
    VOXC_TRY(make(*state));
  return Gpu(std::move(state));
}

} // namespace voxc::gpu
