// Objects of a Vulkan device that are destroyed with what owns them.
#pragma once

#include "voxc/Support/Error.h"

#include <vulkan/vulkan.h>

#include <utility>

namespace voxc::gpu {

/// One object, which `destroy` ends.
template <typename Handle, void (*destroy)(VkDevice, Handle, const VkAllocationCallbacks *)> class Owned {
public:
  using Type = Handle;
  Owned() = default;
  Owned(VkDevice device, Handle handle) : device_(device), handle_(handle) {}
  Owned(Owned &&other) noexcept
      : device_(other.device_), handle_(std::exchange(other.handle_, VK_NULL_HANDLE)) {}
  Owned &operator=(Owned &&other) noexcept {
    std::swap(device_, other.device_);
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Owned() {
    if (handle_ != VK_NULL_HANDLE)
      destroy(device_, handle_, nullptr);
  }

  Handle get() const { return handle_; }

private:
  VkDevice device_ = VK_NULL_HANDLE;
  Handle handle_ = VK_NULL_HANDLE;
};

using OwnedBuffer = Owned<VkBuffer, vkDestroyBuffer>;
using OwnedMemory = Owned<VkDeviceMemory, vkFreeMemory>;
using OwnedShader = Owned<VkShaderModule, vkDestroyShaderModule>;
using OwnedSetLayout = Owned<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout>;
using OwnedLayout = Owned<VkPipelineLayout, vkDestroyPipelineLayout>;
using OwnedPipeline = Owned<VkPipeline, vkDestroyPipeline>;
using OwnedPool = Owned<VkDescriptorPool, vkDestroyDescriptorPool>;
using OwnedCommandPool = Owned<VkCommandPool, vkDestroyCommandPool>;
using OwnedQueries = Owned<VkQueryPool, vkDestroyQueryPool>;
using OwnedFence = Owned<VkFence, vkDestroyFence>;

/// What Vulkan returned, as an error: "the device cannot VERB: REASON".
Error gpuError(const char *verb, VkResult result);

/// Makes an object by a function of Vulkan's, as vkCreateFence.
template <typename Object, typename Create, typename Info>
Expected<Object> make(VkDevice device, Create create, const Info &info, const char *verb) {
  typename Object::Type handle = VK_NULL_HANDLE;
  if (const VkResult result = create(device, &info, nullptr, &handle); result != VK_SUCCESS)
    return gpuError(verb, result);
  return Object(device, handle);
}

} // namespace voxc::gpu
