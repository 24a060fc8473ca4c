// Vulkan's functions, looked up when first needed: a machine without the loader runs everything else.
#pragma once

#ifndef VK_NO_PROTOTYPES
#define VK_NO_PROTOTYPES
#endif
#include <vulkan/vulkan_core.h>

#include <optional>

/// Every function that voxc calls of an instance and its devices, without vk before it; all are exported by a
/// loader of Vulkan 1.2.
#define VOXC_VULKAN_FUNCTIONS(X)                                                                             \
  X(AllocateCommandBuffers)                                                                                  \
  X(AllocateDescriptorSets)                                                                                  \
  X(AllocateMemory)                                                                                          \
  X(BeginCommandBuffer)                                                                                      \
  X(BindBufferMemory)                                                                                        \
  X(CmdBindDescriptorSets)                                                                                   \
  X(CmdBindPipeline)                                                                                         \
  X(CmdCopyBuffer)                                                                                           \
  X(CmdDispatch)                                                                                             \
  X(CmdDispatchIndirect)                                                                                     \
  X(CmdPipelineBarrier)                                                                                      \
  X(CmdPushConstants)                                                                                        \
  X(CmdUpdateBuffer)                                                                                         \
  X(CmdResetQueryPool)                                                                                       \
  X(CmdWriteTimestamp)                                                                                       \
  X(CreateBuffer)                                                                                            \
  X(CreateCommandPool)                                                                                       \
  X(CreateComputePipelines)                                                                                  \
  X(CreateBufferView)                                                                                        \
  X(CreateDescriptorPool)                                                                                    \
  X(CreateDescriptorSetLayout)                                                                               \
  X(CreateDevice)                                                                                            \
  X(CreateFence)                                                                                             \
  X(CreatePipelineCache)                                                                                     \
  X(CreatePipelineLayout)                                                                                    \
  X(CreateQueryPool)                                                                                         \
  X(CreateShaderModule)                                                                                      \
  X(DestroyBuffer)                                                                                           \
  X(DestroyCommandPool)                                                                                      \
  X(DestroyBufferView)                                                                                       \
  X(DestroyDescriptorPool)                                                                                   \
  X(DestroyDescriptorSetLayout)                                                                              \
  X(DestroyDevice)                                                                                           \
  X(DestroyFence)                                                                                            \
  X(DestroyInstance)                                                                                         \
  X(DestroyPipeline)                                                                                         \
  X(DestroyPipelineCache)                                                                                    \
  X(DestroyPipelineLayout)                                                                                   \
  X(DestroyQueryPool)                                                                                        \
  X(DestroyShaderModule)                                                                                     \
  X(EndCommandBuffer)                                                                                        \
  X(EnumeratePhysicalDevices)                                                                                \
  X(FreeMemory)                                                                                              \
  X(GetBufferDeviceAddress)                                                                                  \
  X(GetBufferMemoryRequirements)                                                                             \
  X(GetDeviceQueue)                                                                                          \
  X(GetPhysicalDeviceFeatures2)                                                                              \
  X(GetPhysicalDeviceMemoryProperties)                                                                       \
  X(GetPhysicalDeviceProperties)                                                                             \
  X(GetPhysicalDeviceProperties2)                                                                            \
  X(GetPhysicalDeviceQueueFamilyProperties)                                                                  \
  X(GetPipelineCacheData)                                                                                    \
  X(GetQueryPoolResults)                                                                                     \
  X(MapMemory)                                                                                               \
  X(QueueSubmit)                                                                                             \
  X(ResetCommandPool)                                                                                        \
  X(ResetFences)                                                                                             \
  X(UpdateDescriptorSets)                                                                                    \
  X(WaitForFences)

namespace voxc {

/// The functions of an instance and its devices.
struct VulkanFunctions {
#define VOXC_DECLARE(name) PFN_vk##name name = nullptr;
  VOXC_VULKAN_FUNCTIONS(VOXC_DECLARE)
#undef VOXC_DECLARE
};

/// The loader of this machine.
struct VulkanLoader {
  PFN_vkCreateInstance CreateInstance = nullptr;
  VulkanFunctions functions; ///< For every instance that it makes.
};

/// Loads the loader, once in a process. Null if there is none or it is older than Vulkan 1.2.
const VulkanLoader *loadVulkan();

/// The functions that another loader has for its instance; nothing if one is missing.
std::optional<VulkanFunctions> functionsOf(VkInstance instance, PFN_vkGetInstanceProcAddr loader);

} // namespace voxc
