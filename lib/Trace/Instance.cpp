// The connection to Vulkan.
#include "Instance.h"

namespace voxc {

std::optional<Instance> Instance::create() {
  const VulkanLoader *loader = loadVulkan();
  if (!loader)
    return std::nullopt;
  VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.pApplicationName = "voxc";
  application.apiVersion = VK_API_VERSION_1_2;
  VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &application;
  VkInstance instance = VK_NULL_HANDLE;
  if (loader->CreateInstance(&info, nullptr, &instance) != VK_SUCCESS)
    return std::nullopt;
  return Instance(loader->functions, instance);
}

} // namespace voxc
