// Frames: the picture is copied into the window's image, and the panel drawn over it.
#include "window/Presenter.h"

#include "window/VulkanWindow.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_vulkan.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace voxc::view {
namespace {

constexpr std::uint64_t kForever = std::numeric_limits<std::uint64_t>::max();

constexpr std::array<float, 4> kBackground{0.08f, 0.09f, 0.11f, 1};

/// ImGui needs room for its letters alone.
vk::raii::DescriptorPool makePool(const vk::raii::Device &device) {
  const vk::DescriptorPoolSize size(vk::DescriptorType::eCombinedImageSampler, 1);
  return {device,
          vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, size)};
}

void move(const vk::raii::CommandBuffer &commands, vk::Image image, vk::ImageLayout from, vk::ImageLayout to,
          vk::PipelineStageFlags before, vk::PipelineStageFlags after, vk::AccessFlags written,
          vk::AccessFlags used) {
  const vk::ImageSubresourceRange all(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
  const vk::ImageMemoryBarrier barrier(written, used, from, to, VK_QUEUE_FAMILY_IGNORED,
                                       VK_QUEUE_FAMILY_IGNORED, image, all);
  commands.pipelineBarrier(before, after, {}, nullptr, nullptr, barrier);
}

/// A picture in memory that the device copies from.
struct Staging {
  Staging(const VulkanWindow &window, const Picture &picture)
      : width(std::uint32_t(picture.width)), height(std::uint32_t(picture.height)),
        buffer(window.device, vk::BufferCreateInfo({}, picture.pixels.size() * sizeof(std::uint32_t),
                                                   vk::BufferUsageFlagBits::eTransferSrc)),
        memory(window.hostMemory(buffer)) {
    buffer.bindMemory(*memory, 0);
    words = static_cast<std::uint32_t *>(memory.mapMemory(0, VK_WHOLE_SIZE));
  }

  std::uint32_t width, height;
  vk::raii::Buffer buffer;
  vk::raii::DeviceMemory memory;
  std::uint32_t *words;
};

std::uint32_t swapRedAndBlue(std::uint32_t pixel) {
  return (pixel & 0xff00ff00u) | (pixel >> 16 & 0xff) | (pixel & 0xff) << 16;
}

} // namespace

struct Presenter::State {
  explicit State(GLFWwindow *handle)
      : glfw(handle), window(handle), pool(makePool(window.device)),
        commandPool(window.device,
                    vk::CommandPoolCreateInfo(vk::CommandPoolCreateFlagBits::eResetCommandBuffer,
                                              window.queueFamily)),
        commands(std::move(vk::raii::CommandBuffers(
            window.device,
            vk::CommandBufferAllocateInfo(*commandPool, vk::CommandBufferLevel::ePrimary, 1))[0])),
        acquired(window.device, vk::SemaphoreCreateInfo()),
        finished(window.device, vk::FenceCreateInfo(vk::FenceCreateFlagBits::eSignaled)),
        deviceName(window.physical.getProperties().deviceName.data()) {}

  void startImGui();
  bool makeChain();
  void record(std::uint32_t image, ImDrawData *drawData);
  void recordPicture(vk::Image image);
  bool present(ImDrawData *drawData);
  void waitForFrame() {
    vk::resultCheck(window.device.waitForFences(*finished, true, kForever), "vkWaitForFences");
  }

  GLFWwindow *glfw;
  VulkanWindow window;
  vk::raii::DescriptorPool pool;
  vk::raii::CommandPool commandPool;
  vk::raii::CommandBuffer commands;
  vk::raii::Semaphore acquired;
  vk::raii::Fence finished; ///< The last frame was drawn.
  std::unique_ptr<ImageChain> chain;
  std::unique_ptr<Staging> staging;
  std::string deviceName;
  bool hasImGui = false;
};

void Presenter::State::startImGui() {
  ImGui_ImplGlfw_InitForVulkan(glfw, false); // Whoever has the window tells ImGui what it hears.
  ImGui_ImplVulkan_InitInfo info{};
  info.Instance = *window.instance;
  info.PhysicalDevice = *window.physical;
  info.Device = *window.device;
  info.QueueFamily = window.queueFamily;
  info.Queue = *window.queue;
  info.DescriptorPool = *pool;
  info.MinImageCount = info.ImageCount = 2;
  info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
  ImGui_ImplVulkan_Init(&info, *window.overlay);
  hasImGui = true;
  commands.begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
  ImGui_ImplVulkan_CreateFontsTexture(*commands);
  commands.end();
  window.queue.submit(vk::SubmitInfo({}, {}, *commands));
  window.queue.waitIdle();
  ImGui_ImplVulkan_DestroyFontUploadObjects();
}

/// False if the window has no pixels.
bool Presenter::State::makeChain() {
  int width = 0, height = 0;
  glfwGetFramebufferSize(glfw, &width, &height);
  if (width == 0 || height == 0)
    return false;
  window.device.waitIdle();
  chain = std::make_unique<ImageChain>(window, vk::Extent2D(std::uint32_t(width), std::uint32_t(height)),
                                       chain.get());
  return true;
}

/// Leaves the image ready to be drawn over.
void Presenter::State::recordPicture(vk::Image image) {
  using Layout = vk::ImageLayout;
  using Stage = vk::PipelineStageFlagBits;
  using Access = vk::AccessFlagBits;
  // The wait for the image ends where colours are written; copying begins after that.
  move(commands, image, Layout::eUndefined, Layout::eTransferDstOptimal, Stage::eTransfer, Stage::eTransfer,
       {}, Access::eTransferWrite);
  const vk::Extent2D shown = staging ? vk::Extent2D(std::min(chain->extent.width, staging->width),
                                                    std::min(chain->extent.height, staging->height))
                                     : vk::Extent2D();
  if (shown != chain->extent) {
    const vk::ImageSubresourceRange all(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
    commands.clearColorImage(image, Layout::eTransferDstOptimal, vk::ClearColorValue(kBackground), all);
    move(commands, image, Layout::eTransferDstOptimal, Layout::eTransferDstOptimal, Stage::eTransfer,
         Stage::eTransfer, Access::eTransferWrite, Access::eTransferWrite);
  }
  if (staging) {
    const vk::ImageSubresourceLayers layer(vk::ImageAspectFlagBits::eColor, 0, 0, 1);
    const vk::BufferImageCopy region(0, staging->width, staging->height, layer, {}, vk::Extent3D(shown, 1));
    commands.copyBufferToImage(*staging->buffer, image, Layout::eTransferDstOptimal, region);
  }
  move(commands, image, Layout::eTransferDstOptimal, Layout::eColorAttachmentOptimal, Stage::eTransfer,
       Stage::eColorAttachmentOutput, Access::eTransferWrite,
       Access::eColorAttachmentRead | Access::eColorAttachmentWrite);
}

void Presenter::State::record(std::uint32_t image, ImDrawData *drawData) {
  commands.reset();
  commands.begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
  recordPicture(chain->images[image]);
  const vk::RenderPassBeginInfo pass(*window.overlay, *chain->framebuffers[image],
                                     vk::Rect2D({}, chain->extent));
  commands.beginRenderPass(pass, vk::SubpassContents::eInline);
  ImGui_ImplVulkan_RenderDrawData(drawData, *commands);
  commands.endRenderPass();
  commands.end();
}

bool Presenter::State::present(ImDrawData *drawData) {
  if (!chain && !makeChain())
    return false;
  waitForFrame();
  try {
    const std::uint32_t image = chain->chain.acquireNextImage(kForever, *acquired).second;
    window.device.resetFences(*finished);
    record(image, drawData);
    const vk::PipelineStageFlags copies = vk::PipelineStageFlagBits::eTransfer;
    window.queue.submit(vk::SubmitInfo(*acquired, copies, *commands, *chain->drawn[image]), *finished);
    const vk::Result result =
        window.queue.presentKHR(vk::PresentInfoKHR(*chain->drawn[image], *chain->chain, image));
    if (result == vk::Result::eSuboptimalKHR)
      makeChain();
    return true;
  } catch (const vk::OutOfDateKHRError &) {
    makeChain();
    return false;
  }
}

namespace {

/// What went wrong, of whatever `work` throws.
template <typename Work> auto guarded(const Work &work) -> Expected<decltype(work())> {
  try {
    return work();
  } catch (const std::exception &failure) {
    return Error::environment(std::string("the window cannot be drawn: ") + failure.what());
  }
}

} // namespace

Presenter::Presenter(std::unique_ptr<State> state) : state_(std::move(state)) {}

Presenter::~Presenter() {
  if (!state_->hasImGui)
    return;
  vkDeviceWaitIdle(*state_->window.device);
  ImGui_ImplVulkan_Shutdown();
  ImGui_ImplGlfw_Shutdown();
}

Expected<std::unique_ptr<Presenter>> Presenter::create(GLFWwindow *window) {
  return guarded([window] {
    std::unique_ptr<Presenter> presenter(new Presenter(std::make_unique<State>(window)));
    presenter->state_->startImGui();
    return presenter;
  });
}

const std::string &Presenter::deviceName() const { return state_->deviceName; }

void Presenter::setPicture(const Picture &picture) {
  State &state = *state_;
  state.waitForFrame();
  if (!state.staging || state.staging->width != std::uint32_t(picture.width) ||
      state.staging->height != std::uint32_t(picture.height))
    state.staging = std::make_unique<Staging>(state.window, picture);
  if (state.window.format.format == vk::Format::eB8G8R8A8Unorm)
    std::ranges::transform(picture.pixels, state.staging->words, swapRedAndBlue);
  else
    std::ranges::copy(picture.pixels, state.staging->words);
}

void Presenter::beginFrame() {
  ImGui_ImplVulkan_NewFrame();
  ImGui_ImplGlfw_NewFrame();
}

Expected<bool> Presenter::present(ImDrawData *drawData) {
  return guarded([&] { return state_->present(drawData); });
}

} // namespace voxc::view
