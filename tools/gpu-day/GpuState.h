// What a device is made of.
#pragma once

#include "Gpu.h"

namespace voxc::gpu {

struct Gpu::State {
  State() = default;
  State(const State &) = delete;
  ~State();

  VkInstance instance = VK_NULL_HANDLE;
  VkPhysicalDevice physical = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  std::uint32_t family = 0;
  VkQueue queue = VK_NULL_HANDLE;
  VkPhysicalDeviceMemoryProperties memory{};
  double secondsOfTick = 0;
  GpuFacts facts;
  OwnedCommandPool pool;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  OwnedFence fence;
  OwnedQueries queries;
  GpuBuffer staging; ///< Which the processor sees.
  std::byte *staged = nullptr;
};

inline constexpr std::uint32_t kMostSteps = 16;
inline constexpr std::uint64_t kStagingBytes = std::uint64_t{32} << 20;

/// Memory for a buffer: on the device, or where the processor sees it too.
Expected<GpuBuffer> makeBuffer(const Gpu::State &state, std::uint64_t bytes, VkMemoryPropertyFlags wanted);

} // namespace voxc::gpu
