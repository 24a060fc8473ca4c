// The engine's side of Vulkan: a device that it opens as it likes, buffers in memory that both sides see, its
// own shaders, and frames.
#pragma once

#include <voxc/Trace/HostDevice.h>

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

/// Ends the program where Vulkan says that something failed, as small programs may.
class Engine {
public:
  struct Buffer {
    VkBuffer buffer;
    VkDeviceMemory memory;
    void *mapped;
    VkDeviceSize bytes;
  };

  Engine();
  ~Engine();
  Engine(const Engine &) = delete;
  Engine &operator=(const Engine &) = delete;

  /// The device, for voxc.
  const voxc::HostDevice &host() const { return host_; }

  Buffer makeBuffer(VkDeviceSize bytes, VkBufferUsageFlags alsoFor = 0);
  /// Binds buffers for the engine's own shaders, from binding 0 on.
  void bind(std::span<const Buffer> buffers);
  VkPipeline makePipeline(std::span<const std::uint32_t> spirv);

  void dispatch(VkCommandBuffer commands, VkPipeline pipeline, std::uint32_t x, std::uint32_t y,
                std::uint32_t z) const;
  /// Lets what follows see what compute shaders have written so far.
  static void barrier(VkCommandBuffer commands, VkPipelineStageFlags stage, VkAccessFlags access);

  /// Records one command buffer, submits it, and waits until the frame is there.
  void drawFrame(const std::function<void(VkCommandBuffer)> &record);

private:
  void openDevice();

  voxc::HostDevice host_;
  std::vector<Buffer> buffers_;
  std::vector<VkPipeline> pipelines_;
  VkDescriptorSetLayout setLayout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkDescriptorPool descriptors_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  VkCommandPool commands_ = VK_NULL_HANDLE;
  VkFence fence_ = VK_NULL_HANDLE;
};
