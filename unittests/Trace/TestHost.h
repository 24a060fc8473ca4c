// A host that owns a Vulkan device, as an engine does: it has voxc's functions from its own loader alone.
#pragma once

#include "voxc/Trace/HostDevice.h"

#include <gtest/gtest.h>

#include <dlfcn.h>

#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <vector>

namespace voxc::test {

/// The functions of Vulkan that the host calls.
#define VOXC_HOST_FUNCTIONS(X)                                                                               \
  X(AllocateCommandBuffers)                                                                                  \
  X(AllocateMemory)                                                                                          \
  X(BeginCommandBuffer)                                                                                      \
  X(BindBufferMemory)                                                                                        \
  X(CmdPipelineBarrier)                                                                                      \
  X(CreateBuffer)                                                                                            \
  X(CreateCommandPool)                                                                                       \
  X(CreateDevice)                                                                                            \
  X(DestroyBuffer)                                                                                           \
  X(DestroyCommandPool)                                                                                      \
  X(DestroyDevice)                                                                                           \
  X(DestroyInstance)                                                                                         \
  X(EndCommandBuffer)                                                                                        \
  X(EnumeratePhysicalDevices)                                                                                \
  X(FreeMemory)                                                                                              \
  X(GetBufferMemoryRequirements)                                                                             \
  X(GetDeviceQueue)                                                                                          \
  X(GetPhysicalDeviceMemoryProperties)                                                                       \
  X(MapMemory)                                                                                               \
  X(QueueSubmit)                                                                                             \
  X(QueueWaitIdle)

class Host {
public:
  struct Buffer {
    VkBuffer buffer;
    VkDeviceMemory memory;
    std::byte *bytes;
  };

  /// Nothing if this machine has no Vulkan device. Opened with what is useful, or with no feature at all.
  static std::unique_ptr<Host> open(bool plain = false) {
    std::unique_ptr<Host> host(new Host);
    if (!host->load() || !host->choose())
      return nullptr;
    host->openDevice(plain);
    return host;
  }

  ~Host() {
    for (const Buffer &buffer : buffers_) {
      DestroyBuffer(device.device, buffer.buffer, nullptr);
      FreeMemory(device.device, buffer.memory, nullptr);
    }
    if (pool_ != VK_NULL_HANDLE)
      DestroyCommandPool(device.device, pool_, nullptr);
    if (device.device != VK_NULL_HANDLE)
      DestroyDevice(device.device, nullptr);
    if (device.instance != VK_NULL_HANDLE)
      DestroyInstance(device.instance, nullptr);
  }

  HostDevice device;

  Buffer makeBuffer(VkDeviceSize bytes) {
    Buffer buffer{};
    VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = bytes;
    info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                 VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT;
    EXPECT_EQ(CreateBuffer(device.device, &info, nullptr, &buffer.buffer), VK_SUCCESS);
    VkMemoryRequirements needs;
    GetBufferMemoryRequirements(device.device, buffer.buffer, &needs);
    VkPhysicalDeviceMemoryProperties memory;
    GetPhysicalDeviceMemoryProperties(device.physicalDevice, &memory);
    constexpr VkMemoryPropertyFlags kShared =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    std::uint32_t type = 0;
    while ((memory.memoryTypes[type].propertyFlags & kShared) != kShared ||
           !(needs.memoryTypeBits >> type & 1))
      ++type;
    VkMemoryAllocateInfo allocation{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, nullptr, needs.size, type};
    EXPECT_EQ(AllocateMemory(device.device, &allocation, nullptr, &buffer.memory), VK_SUCCESS);
    EXPECT_EQ(BindBufferMemory(device.device, buffer.buffer, buffer.memory, 0), VK_SUCCESS);
    void *mapped = nullptr;
    EXPECT_EQ(MapMemory(device.device, buffer.memory, 0, VK_WHOLE_SIZE, 0, &mapped), VK_SUCCESS);
    buffer.bytes = static_cast<std::byte *>(mapped);
    std::memset(mapped, 0x5a, bytes); // What was there before is not to matter.
    buffers_.push_back(buffer);
    return buffer;
  }

  /// Records one command buffer, submits it once, and waits for its end.
  void submit(const std::function<void(VkCommandBuffer)> &record) {
    VkCommandBufferAllocateInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, nullptr, pool_,
                                     VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
    VkCommandBuffer commands = VK_NULL_HANDLE;
    ASSERT_EQ(AllocateCommandBuffers(device.device, &info, &commands), VK_SUCCESS);
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    ASSERT_EQ(BeginCommandBuffer(commands, &begin), VK_SUCCESS);
    record(commands);
    VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, VK_ACCESS_SHADER_WRITE_BIT,
                            VK_ACCESS_HOST_READ_BIT};
    CmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                       &barrier, 0, nullptr, 0, nullptr);
    ASSERT_EQ(EndCommandBuffer(commands), VK_SUCCESS);
    VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    ASSERT_EQ(QueueSubmit(device.queue, 1, &submit, VK_NULL_HANDLE), VK_SUCCESS);
    ASSERT_EQ(QueueWaitIdle(device.queue), VK_SUCCESS);
  }

private:
  Host() = default;

  bool load() {
    void *library = dlopen("libvulkan.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!library)
      return false;
    device.getInstanceProcAddr =
        reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(library, "vkGetInstanceProcAddr"));
    // The validation layer, where it is loaded, looks at barriers too.
    setenv("VK_LAYER_ENABLES", "VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT", 1);
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(
        device.getInstanceProcAddr(VK_NULL_HANDLE, "vkCreateInstance"));
    VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.apiVersion = VK_API_VERSION_1_2;
    VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pApplicationInfo = &application;
    if (create(&info, nullptr, &device.instance) != VK_SUCCESS)
      return false;
#define VOXC_HOST_LOAD(name)                                                                                 \
  name = reinterpret_cast<PFN_vk##name>(device.getInstanceProcAddr(device.instance, "vk" #name));
    VOXC_HOST_FUNCTIONS(VOXC_HOST_LOAD)
#undef VOXC_HOST_LOAD
    return true;
  }

  bool choose() {
    std::uint32_t count = 1;
    EnumeratePhysicalDevices(device.instance, &count, &device.physicalDevice);
    return count > 0;
  }

  void openDevice(bool plain) {
    const auto useful = usefulFeatures(device.instance, device.physicalDevice, device.getInstanceProcAddr);
    ASSERT_TRUE(useful) << useful.error().message;
    device.features = plain ? HostFeatures{} : *useful;
    VkPhysicalDeviceBufferDeviceAddressFeatures addresses{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_BUFFER_DEVICE_ADDRESS_FEATURES};
    addresses.bufferDeviceAddress = device.features.bufferDeviceAddress;
    const float priority = 1;
    VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
    info.pNext = &addresses;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.pEnabledFeatures = &device.features.core;
    ASSERT_EQ(CreateDevice(device.physicalDevice, &info, nullptr, &device.device), VK_SUCCESS);
    GetDeviceQueue(device.device, 0, 0, &device.queue);
    VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    ASSERT_EQ(CreateCommandPool(device.device, &pool, nullptr, &pool_), VK_SUCCESS);
  }

#define VOXC_HOST_DECLARE(name) PFN_vk##name name = nullptr;
  VOXC_HOST_FUNCTIONS(VOXC_HOST_DECLARE)
#undef VOXC_HOST_DECLARE
  VkCommandPool pool_ = VK_NULL_HANDLE;
  std::vector<Buffer> buffers_;
};

} // namespace voxc::test
