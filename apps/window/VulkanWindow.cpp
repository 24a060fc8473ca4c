// Devices and image chains of windows.
#include "window/VulkanWindow.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace voxc::view {
namespace {

vk::raii::Instance makeInstance(const vk::raii::Context &context) {
  std::uint32_t count = 0;
  const char **const names = glfwGetRequiredInstanceExtensions(&count);
  if (!names)
    throw std::runtime_error("Vulkan cannot present on this desktop");
  const vk::ApplicationInfo application("voxc view", 0, nullptr, 0, VK_API_VERSION_1_2);
  vk::InstanceCreateInfo info({}, &application);
  info.enabledExtensionCount = count;
  info.ppEnabledExtensionNames = names;
  return {context, info};
}

vk::raii::SurfaceKHR makeSurface(const vk::raii::Instance &instance, GLFWwindow *window) {
  VkSurfaceKHR surface = VK_NULL_HANDLE;
  const VkResult result = glfwCreateWindowSurface(*instance, window, nullptr, &surface);
  vk::resultCheck(vk::Result(result), "glfwCreateWindowSurface");
  return {instance, surface};
}

/// The queue family that draws and presents; none.
std::optional<std::uint32_t> familyOf(const vk::raii::PhysicalDevice &device,
                                      const vk::raii::SurfaceKHR &surface) {
  const auto families = device.getQueueFamilyProperties();
  for (std::uint32_t i = 0; i < families.size(); ++i)
    if ((families[i].queueFlags & vk::QueueFlagBits::eGraphics) && device.getSurfaceSupportKHR(i, *surface))
      return i;
  return std::nullopt;
}

bool hasChains(const vk::raii::PhysicalDevice &device) {
  return std::ranges::any_of(device.enumerateDeviceExtensionProperties(), [](const auto &extension) {
    return std::string_view(extension.extensionName.data()) == VK_KHR_SWAPCHAIN_EXTENSION_NAME;
  });
}

/// A GPU rather than this processor.
vk::raii::PhysicalDevice choose(const vk::raii::Instance &instance, const vk::raii::SurfaceKHR &surface) {
  std::optional<vk::raii::PhysicalDevice> best;
  for (const vk::raii::PhysicalDevice &device : vk::raii::PhysicalDevices(instance)) {
    if (!hasChains(device) || !familyOf(device, surface))
      continue;
    const bool isProcessor = device.getProperties().deviceType == vk::PhysicalDeviceType::eCpu;
    if (!best || (!isProcessor && best->getProperties().deviceType == vk::PhysicalDeviceType::eCpu))
      best = device;
  }
  if (!best)
    throw std::runtime_error(
        "no Vulkan device can present on this display; install a driver, such as Mesa's lavapipe");
  return *best;
}

vk::raii::Device makeDevice(const vk::raii::PhysicalDevice &physical, std::uint32_t family) {
  constexpr float kPriority = 1;
  const vk::DeviceQueueCreateInfo queue({}, family, 1, &kPriority);
  const char *const extension = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
  return {physical, vk::DeviceCreateInfo({}, queue, {}, extension)};
}

/// Four bytes of numbers as they are, for pictures are of a screen's colours already.
vk::SurfaceFormatKHR chooseFormat(const vk::raii::PhysicalDevice &physical,
                                  const vk::raii::SurfaceKHR &surface) {
  for (const vk::SurfaceFormatKHR &format : physical.getSurfaceFormatsKHR(*surface))
    if (format.format == vk::Format::eB8G8R8A8Unorm || format.format == vk::Format::eR8G8B8A8Unorm)
      return format;
  throw std::runtime_error("the display has no format of four bytes a pixel");
}

vk::raii::RenderPass makeOverlay(const vk::raii::Device &device, vk::Format format) {
  using Layout = vk::ImageLayout;
  const vk::AttachmentDescription image({}, format, vk::SampleCountFlagBits::e1, vk::AttachmentLoadOp::eLoad,
                                        vk::AttachmentStoreOp::eStore, vk::AttachmentLoadOp::eDontCare,
                                        vk::AttachmentStoreOp::eDontCare, Layout::eColorAttachmentOptimal,
                                        Layout::ePresentSrcKHR);
  const vk::AttachmentReference colour(0, Layout::eColorAttachmentOptimal);
  const vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, {}, colour);
  return {device, vk::RenderPassCreateInfo({}, image, subpass)};
}

} // namespace

VulkanWindow::VulkanWindow(GLFWwindow *window)
    : instance(makeInstance(context)), surface(makeSurface(instance, window)),
      physical(choose(instance, surface)), queueFamily(*familyOf(physical, surface)),
      device(makeDevice(physical, queueFamily)), queue(device, queueFamily, 0),
      format(chooseFormat(physical, surface)), overlay(makeOverlay(device, format.format)) {}

vk::raii::DeviceMemory VulkanWindow::hostMemory(const vk::raii::Buffer &buffer) const {
  constexpr auto kWanted =
      vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent;
  const vk::MemoryRequirements needs = buffer.getMemoryRequirements();
  const vk::PhysicalDeviceMemoryProperties memory = physical.getMemoryProperties();
  for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i)
    if ((needs.memoryTypeBits >> i & 1) && (memory.memoryTypes[i].propertyFlags & kWanted) == kWanted)
      return {device, vk::MemoryAllocateInfo(needs.size, i)};
  throw std::runtime_error("the device has no memory that this processor can write");
}

ImageChain::ImageChain(const VulkanWindow &window, vk::Extent2D wanted, const ImageChain *old)
    : chain(nullptr) {
  const vk::SurfaceCapabilitiesKHR can = window.physical.getSurfaceCapabilitiesKHR(*window.surface);
  const bool isFree = can.currentExtent.width == std::numeric_limits<std::uint32_t>::max();
  extent = isFree ? wanted : can.currentExtent;
  vk::SwapchainCreateInfoKHR info;
  info.surface = *window.surface;
  info.minImageCount =
      can.maxImageCount > 0 ? std::min(can.minImageCount + 1, can.maxImageCount) : can.minImageCount + 1;
  info.imageFormat = window.format.format;
  info.imageColorSpace = window.format.colorSpace;
  info.imageExtent = extent;
  info.imageArrayLayers = 1;
  info.imageUsage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferDst;
  info.preTransform = can.currentTransform;
  info.compositeAlpha = vk::CompositeAlphaFlagBitsKHR::eOpaque;
  // Always there; frames are drawn when something changed, so that waiting for the screen costs nothing.
  info.presentMode = vk::PresentModeKHR::eFifo;
  info.clipped = true;
  info.oldSwapchain = old ? *old->chain : nullptr;
  chain = {window.device, info};
  for (const VkImage image : chain.getImages()) {
    images.emplace_back(image);
    const vk::ImageSubresourceRange all(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
    views.emplace_back(window.device,
                       vk::ImageViewCreateInfo({}, image, vk::ImageViewType::e2D, info.imageFormat, {}, all));
    framebuffers.emplace_back(window.device, vk::FramebufferCreateInfo({}, *window.overlay, *views.back(),
                                                                       extent.width, extent.height, 1));
    drawn.emplace_back(window.device, vk::SemaphoreCreateInfo());
  }
}

} // namespace voxc::view
