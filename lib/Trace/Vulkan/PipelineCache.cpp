// What a driver made of a kernel, kept for the next time.
#include "PipelineCache.h"

#include <cstring>

namespace voxc {
namespace {

constexpr std::string_view kKind = "pipeline";

/// The header of the data, of version one.
constexpr std::size_t kHeaderBytes = 16 + VK_UUID_SIZE;

std::string_view bytesOf(const auto &value) { return {reinterpret_cast<const char *>(&value), sizeof value}; }

/// The header that data of a device must have.
std::string headerOf(const VkPhysicalDeviceProperties &device) {
  const std::uint32_t words[] = {kHeaderBytes, VK_PIPELINE_CACHE_HEADER_VERSION_ONE, device.vendorID,
                                 device.deviceID};
  return std::string(bytesOf(words)).append(bytesOf(device.pipelineCacheUUID));
}

} // namespace

bool isPipelineData(std::string_view bytes, const VkPhysicalDeviceProperties &device) {
  return bytes.size() > kHeaderBytes && bytes.starts_with(headerOf(device));
}

PipelineCache::PipelineCache(const Device::State &device, const CompileCache *cache, std::string_view kernel,
                             std::string_view constants)
    : device_(device), cache_(cache), kernel_(kernel), constants_(constants) {
  if (!cache)
    return;
  device.vk.GetPhysicalDeviceProperties(device.physical.handle, &properties_);
  identity_ = headerOf(properties_).append(bytesOf(properties_.driverVersion));
  const std::string_view parts[] = {identity_, kernel_, constants_};
  if (auto found = cache->find(kKind, parts); found && isPipelineData(*found, properties_))
    found_ = std::move(*found);
  VkPipelineCacheCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
  info.initialDataSize = found_.size();
  info.pInitialData = found_.data();
  if (auto made = createObject<PipelineCacheHandle>(device, &VulkanFunctions::CreatePipelineCache, info,
                                                    "make a pipeline cache"))
    handle_ = std::move(*made);
}

std::string PipelineCache::data() const {
  const VulkanFunctions &vk = device_.vk;
  std::size_t size = 0;
  if (vk.GetPipelineCacheData(device_.device, handle_.get(), &size, nullptr) != VK_SUCCESS)
    return "";
  std::string bytes(size, '\0');
  if (vk.GetPipelineCacheData(device_.device, handle_.get(), &size, bytes.data()) != VK_SUCCESS)
    return "";
  bytes.resize(size);
  return bytes;
}

void PipelineCache::store() const {
  if (!handle_)
    return;
  const std::string made = data();
  const std::string_view parts[] = {identity_, kernel_, constants_};
  if (made != found_ && isPipelineData(made, properties_))
    cache_->store(kKind, parts, made);
}

} // namespace voxc
