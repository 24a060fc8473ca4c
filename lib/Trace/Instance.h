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
      vkDestroyInstance(instance_, nullptr);
  }
  Instance(Instance &&other) noexcept : instance_(std::exchange(other.instance_, VK_NULL_HANDLE)) {}
  Instance &operator=(Instance &&) = delete;

  VkInstance get() const { return instance_; }

private:
  explicit Instance(VkInstance instance) : instance_(instance) {}
  VkInstance instance_;
};

} // namespace voxc
