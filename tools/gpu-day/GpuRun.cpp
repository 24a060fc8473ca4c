// Memory of a device, and what runs there.
#include "GpuState.h"
#include "Program.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace voxc::gpu {
namespace {

constexpr std::uint32_t kNoType = ~0u;

std::uint32_t typeWith(const VkPhysicalDeviceMemoryProperties &memory, std::uint32_t allowed,
                       VkMemoryPropertyFlags wanted) {
  for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type)
    if ((allowed >> type & 1) && (memory.memoryTypes[type].propertyFlags & wanted) == wanted)
      return type;
  return kNoType;
}

/// What is written before is seen after.
void recordBarrier(VkCommandBuffer commands) {
  VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
  barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                       VK_PIPELINE_STAGE_ALL_COMMANDS_BIT | VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier, 0,
                       nullptr, 0, nullptr);
}

Expected<void> begin(const Gpu::State &state) {
  VkCommandBufferBeginInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  VkResult result = vkResetCommandPool(state.device, state.pool.get(), 0);
  if (result == VK_SUCCESS)
    result = vkBeginCommandBuffer(state.commands, &info);
  return result == VK_SUCCESS ? Expected<void>() : gpuError("record commands", result);
}

Expected<void> submitAndWait(const Gpu::State &state) {
  const VkFence fence = state.fence.get();
  VkSubmitInfo info{VK_STRUCTURE_TYPE_SUBMIT_INFO};
  info.commandBufferCount = 1;
  info.pCommandBuffers = &state.commands;
  VkResult result = vkEndCommandBuffer(state.commands);
  if (result == VK_SUCCESS)
    result = vkResetFences(state.device, 1, &fence);
  if (result == VK_SUCCESS)
    result = vkQueueSubmit(state.queue, 1, &info, fence);
  if (result == VK_SUCCESS)
    result = vkWaitForFences(state.device, 1, &fence, VK_TRUE, std::numeric_limits<std::uint64_t>::max());
  return result == VK_SUCCESS ? Expected<void>() : gpuError("finish its work", result);
}

Expected<void> copy(const Gpu::State &state, VkBuffer from, VkBuffer to, VkBufferCopy region) {
  VOXC_TRY(begin(state));
  vkCmdCopyBuffer(state.commands, from, to, 1, &region);
  recordBarrier(state.commands);
  return submitAndWait(state);
}

void record(const Gpu::State &state, const GpuStep &step) {
  if (!step.program) {
    vkCmdUpdateBuffer(state.commands, step.written->buffer.get(), 0,
                      step.words.size() * sizeof(std::uint32_t), step.words.data());
    return;
  }
  step.program->record(state.commands, step.words);
  if (step.groups)
    vkCmdDispatchIndirect(state.commands, step.groups->buffer.get(), 0);
  else
    vkCmdDispatch(state.commands, step.groupsX, step.groupsY, 1);
}

} // namespace

Expected<GpuBuffer> makeBuffer(const Gpu::State &state, std::uint64_t bytes, VkMemoryPropertyFlags wanted) {
  GpuBuffer made;
  made.bytes = std::max<std::uint64_t>((bytes + 15) & ~std::uint64_t{15}, 16);
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = made.bytes;
  info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
               VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  made.buffer = VOXC_TRY(make<OwnedBuffer>(state.device, vkCreateBuffer, info, "make a buffer"));
  VkMemoryRequirements needs{};
  vkGetBufferMemoryRequirements(state.device, made.buffer.get(), &needs);
  VkMemoryAllocateInfo allocation{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  allocation.allocationSize = needs.size;
  allocation.memoryTypeIndex = typeWith(state.memory, needs.memoryTypeBits, wanted);
  if (allocation.memoryTypeIndex == kNoType)
    return Error::environment("the device has no memory of the kind that a buffer needs");
  constexpr const char *kVerb = "give a buffer memory";
  made.memory = VOXC_TRY(make<OwnedMemory>(state.device, vkAllocateMemory, allocation, kVerb));
  if (const VkResult result = vkBindBufferMemory(state.device, made.buffer.get(), made.memory.get(), 0);
      result != VK_SUCCESS)
    return gpuError(kVerb, result);
  return made;
}

Expected<GpuBuffer> Gpu::makeBuffer(std::uint64_t bytes) const {
  return gpu::makeBuffer(*state_, bytes, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
}

Expected<void> Gpu::upload(const GpuBuffer &buffer, std::span<const std::byte> bytes) const {
  for (std::uint64_t done = 0; done < bytes.size(); done += kStagingBytes) {
    const std::uint64_t size = std::min<std::uint64_t>(kStagingBytes, bytes.size() - done);
    std::memcpy(state_->staged, bytes.data() + done, size);
    if (auto copied = copy(*state_, state_->staging.buffer.get(), buffer.buffer.get(), {0, done, size});
        !copied)
      return copied;
  }
  return {};
}

Expected<void> Gpu::download(const GpuBuffer &buffer, std::span<std::byte> bytes) const {
  for (std::uint64_t done = 0; done < bytes.size(); done += kStagingBytes) {
    const std::uint64_t size = std::min<std::uint64_t>(kStagingBytes, bytes.size() - done);
    if (auto copied = copy(*state_, buffer.buffer.get(), state_->staging.buffer.get(), {done, 0, size});
        !copied)
      return copied;
    std::memcpy(bytes.data() + done, state_->staged, size);
  }
  return {};
}

Expected<std::vector<double>> Gpu::run(std::span<const GpuStep> steps) const {
  if (steps.size() > kMostSteps)
    return Error::usage("there are more steps than are timed at once");
  VOXC_TRY(begin(*state_));
  const auto count = static_cast<std::uint32_t>(steps.size());
  const VkQueryPool queries = state_->queries.get();
  vkCmdResetQueryPool(state_->commands, queries, 0, count + 1);
  vkCmdWriteTimestamp(state_->commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, queries, 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    record(*state_, steps[i]);
    recordBarrier(state_->commands);
    vkCmdWriteTimestamp(state_->commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, queries, i + 1);
  }
  VOXC_TRY(submitAndWait(*state_));
  std::array<std::uint64_t, kMostSteps + 1> ticks{};
  if (const VkResult result =
          vkGetQueryPoolResults(state_->device, queries, 0, count + 1, sizeof ticks, ticks.data(),
                                sizeof ticks[0], VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT);
      result != VK_SUCCESS)
    return gpuError("read its times", result);
  std::vector<double> seconds(count);
  for (std::uint32_t i = 0; i < count; ++i)
    seconds[i] = static_cast<double>(ticks[i + 1] - ticks[i]) * state_->secondsOfTick;
  return seconds;
}

} // namespace voxc::gpu
