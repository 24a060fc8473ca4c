// The connection to Vulkan.
#pragma once

#include "Vulkan.h"

#include <optional>
#include <utility>

namespace voxc {

/// Owns a VkInstance.
class VulkanInstance {
public:
  /// Nothing if this machine has no loader, or no driver.
  static std::optional<VulkanInstance> create();
  ~VulkanInstance() {
    if (instance_ != VK_NULL_HANDLE)
      functions_->DestroyInstance(instance_, nullptr);
  }
  VulkanInstance(VulkanInstance &&other) noexcept
      : functions_(other.functions_), instance_(std::exchange(other.instance_, VK_NULL_HANDLE)) {}
  VulkanInstance &operator=(VulkanInstance &&) = delete;

  VkInstance get() const { return instance_; }
  const VulkanFunctions &functions() const { return *functions_; }

private:
  VulkanInstance(const VulkanFunctions &functions, VkInstance instance)
      : functions_(&functions), instance_(instance) {}

  const VulkanFunctions *functions_; ///< Of the loader, which stays.
  VkInstance instance_;
};

} // namespace voxc
