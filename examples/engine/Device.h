// A Vulkan device that traces rays by pipelines, and buffers in memory that both sides see.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <functional>
#include <vector>

/// Ends the program with a sentence.
[[noreturn]] void fail(const char *problem);
void check(VkResult result, const char *what);

struct Buffer {
  VkBuffer buffer;
  VkDeviceMemory memory;
  void *mapped;
  VkDeviceAddress address;
};

class Device {
public:
  Device();
  ~Device();
  Device(const Device &) = delete;
  Device &operator=(const Device &) = delete;

  VkDevice handle() const { return device_; }
  /// What the device says of records and structures.
  const VkPhysicalDeviceRayTracingPipelinePropertiesKHR &records() const { return records_; }
  const VkPhysicalDeviceAccelerationStructurePropertiesKHR &structures() const { return structures_; }

  /// A function of an extension, which the loader has no name of.
  template <typename Function> Function function(const char *name) const {
    return reinterpret_cast<Function>(vkGetDeviceProcAddr(device_, name));
  }

  /// Which side mostly reads a buffer, and so has it near.
  enum class Reader { Device, Host };
  /// Lives as long as the device. All can be stored to by shaders, and have an address.
  Buffer makeBuffer(VkDeviceSize bytes, VkBufferUsageFlags alsoFor = 0, Reader reader = Reader::Device);

  /// Records one command buffer, submits it, and waits until all is done.
  void run(const std::function<void(VkCommandBuffer)> &record);

private:
  void pick();
  void open();
  std::uint32_t memoryType(std::uint32_t allowed, Reader reader) const;

  VkInstance instance_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  std::uint32_t family_ = 0;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  VkCommandPool commands_ = VK_NULL_HANDLE;
  VkPhysicalDeviceRayTracingPipelinePropertiesKHR records_{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_TRACING_PIPELINE_PROPERTIES_KHR};
  VkPhysicalDeviceAccelerationStructurePropertiesKHR structures_{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_PROPERTIES_KHR};
  std::vector<Buffer> buffers_;
};
