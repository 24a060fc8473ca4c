// What Vulkan needs to present on a window: a device, and a chain of images that follows the window's size.
#pragma once

#include <vulkan/vulkan_raii.hpp>

#include <cstdint>
#include <optional>
#include <vector>

struct GLFWwindow;

namespace voxc::view {

/// A device that can present on a window. Throws vk::SystemError, and std::runtime_error if there is none.
struct VulkanWindow {
  explicit VulkanWindow(GLFWwindow *window);

  vk::raii::Context context;
  vk::raii::Instance instance;
  vk::raii::SurfaceKHR surface;
  vk::raii::PhysicalDevice physical;
  std::uint32_t queueFamily = 0;
  vk::raii::Device device;
  vk::raii::Queue queue;
  vk::SurfaceFormatKHR format;
  vk::raii::RenderPass overlay; ///< Draws over what an image holds, then hands it to the screen.

  /// Memory that the host writes and the device copies from.
  vk::raii::DeviceMemory hostMemory(const vk::raii::Buffer &buffer) const;
};

/// The images of a window of one size.
struct ImageChain {
  /// `old` may go on presenting until this is made.
  ImageChain(const VulkanWindow &window, vk::Extent2D wanted, const ImageChain *old);

  vk::Extent2D extent;
  vk::raii::SwapchainKHR chain;
  std::vector<vk::Image> images;
  std::vector<vk::raii::ImageView> views;
  std::vector<vk::raii::Framebuffer> framebuffers;
  std::vector<vk::raii::Semaphore> drawn; ///< Of each image: it may be presented.
};

} // namespace voxc::view
