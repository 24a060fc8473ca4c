// Vulkan's functions, looked up when first needed: a machine without the loader runs everything else.
#pragma once

#define VK_NO_PROTOTYPES
#include <vulkan/vulkan_core.h>

/// Every function that voxc calls; all are exported by a loader of Vulkan 1.2.
#define VOXC_VULKAN_FUNCTIONS(X)                                                                             \
  X(vkAllocateCommandBuffers)                                                                                \
  X(vkAllocateDescriptorSets)                                                                                \
  X(vkAllocateMemory)                                                                                        \
  X(vkBeginCommandBuffer)                                                                                    \
  X(vkBindBufferMemory)                                                                                      \
  X(vkCmdBindDescriptorSets)                                                                                 \
  X(vkCmdBindPipeline)                                                                                       \
  X(vkCmdCopyBuffer)                                                                                         \
  X(vkCmdDispatch)                                                                                           \
  X(vkCmdDispatchIndirect)                                                                                   \
  X(vkCmdPipelineBarrier)                                                                                    \
  X(vkCmdPushConstants)                                                                                      \
  X(vkCmdUpdateBuffer)                                                                                       \
  X(vkCmdResetQueryPool)                                                                                     \
  X(vkCmdWriteTimestamp)                                                                                     \
  X(vkCreateBuffer)                                                                                          \
  X(vkCreateCommandPool)                                                                                     \
  X(vkCreateComputePipelines)                                                                                \
  X(vkCreateDescriptorPool)                                                                                  \
  X(vkCreateDescriptorSetLayout)                                                                             \
  X(vkCreateDevice)                                                                                          \
  X(vkCreateFence)                                                                                           \
  X(vkCreateInstance)                                                                                        \
  X(vkCreatePipelineLayout)                                                                                  \
  X(vkCreateQueryPool)                                                                                       \
  X(vkCreateShaderModule)                                                                                    \
  X(vkDestroyBuffer)                                                                                         \
  X(vkDestroyCommandPool)                                                                                    \
  X(vkDestroyDescriptorPool)                                                                                 \
  X(vkDestroyDescriptorSetLayout)                                                                            \
  X(vkDestroyDevice)                                                                                         \
  X(vkDestroyFence)                                                                                          \
  X(vkDestroyInstance)                                                                                       \
  X(vkDestroyPipeline)                                                                                       \
  X(vkDestroyPipelineLayout)                                                                                 \
  X(vkDestroyQueryPool)                                                                                      \
  X(vkDestroyShaderModule)                                                                                   \
  X(vkEndCommandBuffer)                                                                                      \
  X(vkEnumeratePhysicalDevices)                                                                              \
  X(vkFreeMemory)                                                                                            \
  X(vkGetBufferDeviceAddress)                                                                                \
  X(vkGetBufferMemoryRequirements)                                                                           \
  X(vkGetDeviceQueue)                                                                                        \
  X(vkGetPhysicalDeviceFeatures2)                                                                            \
  X(vkGetPhysicalDeviceMemoryProperties)                                                                     \
  X(vkGetPhysicalDeviceProperties)                                                                           \
  X(vkGetPhysicalDeviceProperties2)                                                                          \
  X(vkGetPhysicalDeviceQueueFamilyProperties)                                                                \
  X(vkGetQueryPoolResults)                                                                                   \
  X(vkMapMemory)                                                                                             \
  X(vkQueueSubmit)                                                                                           \
  X(vkResetCommandPool)                                                                                      \
  X(vkResetFences)                                                                                           \
  X(vkUpdateDescriptorSets)                                                                                  \
  X(vkWaitForFences)

namespace voxc {

#define VOXC_DECLARE(name) extern PFN_##name name;
VOXC_VULKAN_FUNCTIONS(VOXC_DECLARE)
#undef VOXC_DECLARE

/// Loads the functions, once in a process. False if there is no loader or it is older than Vulkan 1.2; the
/// functions must not be called then.
bool loadVulkan();

} // namespace voxc
