// One command buffer that is recorded, submitted and waited for again and again.
#include "Commands.h"

#include <limits>

namespace voxc {

Expected<Commands> Commands::create(Device::State &device) {
  VkCommandPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  poolInfo.queueFamilyIndex = device.physical.queueFamily;
  auto pool = VOXC_TRY(createObject<CommandPoolHandle>(device, &VulkanFunctions::CreateCommandPool, poolInfo,
                                                       "create a command pool"));
  VkFenceCreateInfo fenceInfo{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  auto fence =
      VOXC_TRY(createObject<FenceHandle>(device, &VulkanFunctions::CreateFence, fenceInfo, "create a fence"));
  Commands commands(device, std::move(pool), std::move(fence));
  VkCommandBufferAllocateInfo bufferInfo{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  bufferInfo.commandPool = commands.pool_.get();
  bufferInfo.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  bufferInfo.commandBufferCount = 1;
  if (VkResult result = device.vk.AllocateCommandBuffers(device.device, &bufferInfo, &commands.buffer_);
      result != VK_SUCCESS)
    return vulkanError("allocate a command buffer", result);
  return commands;
}

Expected<VkCommandBuffer> Commands::begin() {
  VkCommandBufferBeginInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  if (VkResult result = device_->vk.ResetCommandPool(device_->device, pool_.get(), 0); result != VK_SUCCESS)
    return vulkanError("reset its commands", result);
  if (VkResult result = device_->vk.BeginCommandBuffer(buffer_, &info); result != VK_SUCCESS)
    return vulkanError("record commands", result);
  return buffer_;
}

Expected<void> Commands::submit() {
  if (VkResult result = device_->vk.EndCommandBuffer(buffer_); result != VK_SUCCESS)
    return vulkanError("record commands", result);
  VkFence fence = fence_.get();
  if (VkResult result = device_->vk.ResetFences(device_->device, 1, &fence); result != VK_SUCCESS)
    return vulkanError("reset a fence", result);
  VkSubmitInfo info{VK_STRUCTURE_TYPE_SUBMIT_INFO};
  info.commandBufferCount = 1;
  info.pCommandBuffers = &buffer_;
  if (VkResult result = device_->vk.QueueSubmit(device_->queue, 1, &info, fence); result != VK_SUCCESS)
    return vulkanError("take commands", result);
  return {};
}

Expected<void> Commands::wait() {
  VkFence fence = fence_.get();
  constexpr auto kForever = std::numeric_limits<std::uint64_t>::max();
  if (VkResult result = device_->vk.WaitForFences(device_->device, 1, &fence, VK_TRUE, kForever);
      result != VK_SUCCESS)
    return vulkanError("finish its work", result);
  return {};
}

void recordBarrier(const Device::State &device, VkCommandBuffer commands) {
  VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
  barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
  device.vk.CmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                               VK_PIPELINE_STAGE_ALL_COMMANDS_BIT | VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                               &barrier, 0, nullptr, 0, nullptr);
}

} // namespace voxc
