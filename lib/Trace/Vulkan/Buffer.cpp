// Device buffers with the memory behind them.
#include "Buffer.h"

namespace voxc {
namespace {

Error tooLarge(const Device::State &device, const BufferRequest &request) {
  return Error::environment(std::string(request.what) + " need " + bytesText(request.bytes) +
                            " at once, but " + device.info().name + " allocates at most " +
                            bytesText(device.info().maxAllocationBytes) + " at once");
}

VkBufferCreateInfo createInfo(const BufferRequest &request) {
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = request.bytes;
  info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
               VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  if (request.addressed)
    info.usage |= VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;
  if (request.texels)
    info.usage |= VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;
  if (request.starts)
    info.usage |= VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT;
  info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
  return info;
}

} // namespace

Expected<Buffer> Buffer::create(Device::State &device, const BufferRequest &request) {
  if (request.bytes > device.info().maxAllocationBytes)
    return tooLarge(device, request);
  auto handle = VOXC_TRY(createObject<BufferHandle>(device, &VulkanFunctions::CreateBuffer,
                                                    createInfo(request), "create a buffer"));
  Buffer buffer(std::move(handle), request.bytes);
  VOXC_TRY(buffer.bind(device, request));
  return buffer;
}

Expected<void> Buffer::bind(Device::State &device, const BufferRequest &request) {
  std::string action = "hold " + std::string(request.what) + " (" + bytesText(request.bytes) + ")";
  if (VkResult result = allocate(device, request); result != VK_SUCCESS)
    return vulkanError(action, result);
  if (VkResult result = device.vk.BindBufferMemory(device.device, buffer_.get(), memory_.get(), 0);
      result != VK_SUCCESS)
    return vulkanError(action, result);
  return {};
}

VkResult Buffer::allocate(Device::State &device, const BufferRequest &request) {
  VkMemoryRequirements needs{};
  device.vk.GetBufferMemoryRequirements(device.device, buffer_.get(), &needs);
  VkMemoryAllocateFlagsInfo flags{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO};
  flags.flags = request.addressed ? VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT : 0;
  VkResult result = VK_ERROR_OUT_OF_DEVICE_MEMORY;
  for (std::uint32_t type : memoryTypesFor(device.physical.memory, needs.memoryTypeBits, request.placement)) {
    VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, &flags, needs.size, type};
    VkDeviceMemory allocated = VK_NULL_HANDLE;
    result = device.vk.AllocateMemory(device.device, &info, nullptr, &allocated);
    if (result != VK_SUCCESS)
      continue;
    memory_ = MemoryHandle(device, allocated);
    return map(device, type);
  }
  return result;
}

VkResult Buffer::map(Device::State &device, std::uint32_t type) {
  VkMemoryPropertyFlags properties = device.physical.memory.memoryTypes[type].propertyFlags;
  if (!isMappable(properties))
    return VK_SUCCESS;
  void *mapped = nullptr;
  VkResult result = device.vk.MapMemory(device.device, memory_.get(), 0, VK_WHOLE_SIZE, 0, &mapped);
  mapped_ = static_cast<std::byte *>(mapped);
  cached_ = properties & VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
  return result;
}

VkDeviceAddress Buffer::address(const Device::State &device) const {
  VkBufferDeviceAddressInfo info{VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO, nullptr, buffer_.get()};
  return device.vk.GetBufferDeviceAddress(device.device, &info);
}

} // namespace voxc
