// Owners of Vulkan objects.
#pragma once

#include "VulkanError.h"

#include <utility>

namespace voxc {

/// Owns one object of a device and destroys it.
template <typename ObjectType, auto &destroy> class Handle {
public:
  using Object = ObjectType;

  Handle() = default;
  Handle(VkDevice device, Object object) : device_(device), object_(object) {}
  ~Handle() {
    if (object_ != VK_NULL_HANDLE)
      destroy(device_, object_, nullptr);
  }
  Handle(Handle &&other) noexcept
      : device_(other.device_), object_(std::exchange(other.object_, VK_NULL_HANDLE)) {}
  Handle &operator=(Handle &&other) noexcept {
    std::swap(device_, other.device_);
    std::swap(object_, other.object_);
    return *this;
  }

  Object get() const { return object_; }
  explicit operator bool() const { return object_ != VK_NULL_HANDLE; }

private:
  VkDevice device_ = VK_NULL_HANDLE;
  Object object_ = VK_NULL_HANDLE;
};

using BufferHandle = Handle<VkBuffer, vkDestroyBuffer>;
using MemoryHandle = Handle<VkDeviceMemory, vkFreeMemory>;
using FenceHandle = Handle<VkFence, vkDestroyFence>;
using CommandPoolHandle = Handle<VkCommandPool, vkDestroyCommandPool>;
using QueryPoolHandle = Handle<VkQueryPool, vkDestroyQueryPool>;
using ShaderModuleHandle = Handle<VkShaderModule, vkDestroyShaderModule>;
using SetLayoutHandle = Handle<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout>;
using DescriptorPoolHandle = Handle<VkDescriptorPool, vkDestroyDescriptorPool>;
using PipelineLayoutHandle = Handle<VkPipelineLayout, vkDestroyPipelineLayout>;
using PipelineHandle = Handle<VkPipeline, vkDestroyPipeline>;

/// Calls `create` with `info` and owns what it makes; `action` names it in an error ("create a fence").
template <typename Owner, typename Create, typename Info>
Expected<Owner> createObject(VkDevice device, Create create, const Info &info, std::string_view action) {
  typename Owner::Object object = VK_NULL_HANDLE;
  if (VkResult result = create(device, &info, nullptr, &object); result != VK_SUCCESS)
    return vulkanError(action, result);
  return Owner(device, object);
}

} // namespace voxc
