// Owners of Vulkan objects.
#pragma once

#include "DeviceState.h"
#include "VulkanError.h"

#include <utility>

namespace voxc {

/// Owns one object of an open device, which outlives it, and destroys it by that function.
template <typename ObjectType, auto destroy> class Handle {
public:
  using Object = ObjectType;

  Handle() = default;
  Handle(const Device::State &device, Object object) : device_(&device), object_(object) {}
  ~Handle() {
    if (object_ != VK_NULL_HANDLE)
      (device_->vk.*destroy)(device_->device, object_, nullptr);
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
  const Device::State *device_ = nullptr;
  Object object_ = VK_NULL_HANDLE;
};

using BufferHandle = Handle<VkBuffer, &VulkanFunctions::DestroyBuffer>;
using BufferViewHandle = Handle<VkBufferView, &VulkanFunctions::DestroyBufferView>;
using MemoryHandle = Handle<VkDeviceMemory, &VulkanFunctions::FreeMemory>;
using FenceHandle = Handle<VkFence, &VulkanFunctions::DestroyFence>;
using CommandPoolHandle = Handle<VkCommandPool, &VulkanFunctions::DestroyCommandPool>;
using QueryPoolHandle = Handle<VkQueryPool, &VulkanFunctions::DestroyQueryPool>;
using ShaderModuleHandle = Handle<VkShaderModule, &VulkanFunctions::DestroyShaderModule>;
using SetLayoutHandle = Handle<VkDescriptorSetLayout, &VulkanFunctions::DestroyDescriptorSetLayout>;
using DescriptorPoolHandle = Handle<VkDescriptorPool, &VulkanFunctions::DestroyDescriptorPool>;
using PipelineCacheHandle = Handle<VkPipelineCache, &VulkanFunctions::DestroyPipelineCache>;
using PipelineLayoutHandle = Handle<VkPipelineLayout, &VulkanFunctions::DestroyPipelineLayout>;
using PipelineHandle = Handle<VkPipeline, &VulkanFunctions::DestroyPipeline>;

/// Calls the function `create` of Vulkan with `info` and owns what it makes; `action` names it in an error
/// ("create a fence").
template <typename Owner, typename Create, typename Info>
Expected<Owner> createObject(const Device::State &device, Create create, const Info &info,
                             std::string_view action) {
  typename Owner::Object object = VK_NULL_HANDLE;
  if (VkResult result = (device.vk.*create)(device.device, &info, nullptr, &object); result != VK_SUCCESS)
    return vulkanError(action, result);
  return Owner(device, object);
}

} // namespace voxc
