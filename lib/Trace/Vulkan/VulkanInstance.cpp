// The connection to Vulkan.
#include "VulkanInstance.h"

namespace voxc {

std::optional<VulkanInstance> VulkanInstance::create() {
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
  return VulkanInstance(loader->functions, instance);
}

} // namespace voxc
