// The connection to Vulkan.
#pragma once

#include "Vulkan.h"

#include <optional>
#include <utility>

namespace voxc {

/// Owns a VkInstance.
class Instance {
public:
  /// Nothing if this machine has no loader, or no driver.
  static std::optional<Instance> create();
  ~Instance() {
    if (instance_ != VK_NULL_HANDLE)
      functions_->DestroyInstance(instance_, nullptr);
  }
  Instance(Instance &&other) noexcept
      : functions_(other.functions_), instance_(std::exchange(other.instance_, VK_NULL_HANDLE)) {}
  Instance &operator=(Instance &&) = delete;

  VkInstance get() const { return instance_; }
  const VulkanFunctions &functions() const { return *functions_; }

private:
  Instance(const VulkanFunctions &functions, VkInstance instance)
      : functions_(&functions), instance_(instance) {}

  const VulkanFunctions *functions_; ///< Of the loader, which stays.
  VkInstance instance_;
};

} // namespace voxc
