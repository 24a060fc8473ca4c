// One compute shader on the first Vulkan device: buffers at its bindings, push constants, and no more.
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Ends the program where Vulkan says that something failed, as small programs may.
class Compute {
public:
  /// A pipeline of `spirv` with so many bytes of push constants, and a buffer for each of `sizes`, at
  /// bindings from 0 on.
  Compute(std::span<const std::uint32_t> spirv, std::uint32_t pushBytes, std::span<const std::size_t> sizes);
  ~Compute();
  Compute(const Compute &) = delete;
  Compute &operator=(const Compute &) = delete;

  /// The memory of a buffer, which both sides see.
  void *memory(std::size_t binding) const { return buffers_[binding].mapped; }
  /// Runs x * y workgroups to their end.
  void run(const void *push, std::uint32_t x, std::uint32_t y);

private:
  struct Buffer {
    VkBuffer buffer;
    VkDeviceMemory memory;
    void *mapped;
  };

  void openDevice();
  Buffer makeBuffer(std::size_t size);
  void makePipeline(std::span<const std::uint32_t> spirv);
  void bindBuffers();

  std::uint32_t pushBytes_;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  std::uint32_t family_ = 0;
  VkQueue queue_ = VK_NULL_HANDLE;
  std::vector<Buffer> buffers_;
  VkDescriptorSetLayout setLayout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  VkDescriptorPool descriptors_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  VkCommandPool commands_ = VK_NULL_HANDLE;
};
