// The engine's side of Vulkan.
#include "Engine.h"

#include <cstdio>
#include <cstdlib>

namespace {

[[noreturn]] void fail(const char *problem) {
  std::fprintf(stderr, "host-device: %s\n", problem);
  std::exit(1);
}

void check(VkResult result, const char *what) {
  if (result == VK_SUCCESS)
    return;
  std::fprintf(stderr, "host-device: %s failed with VkResult %d\n", what, result);
  std::exit(1);
}

} // namespace

Engine::Engine() {
  openDevice();
  const VkCommandPoolCreateInfo poolInfo{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                         .queueFamilyIndex = host_.queueFamily};
  check(vkCreateCommandPool(host_.device, &poolInfo, nullptr, &commands_), "vkCreateCommandPool");
  const VkFenceCreateInfo fenceInfo{.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  check(vkCreateFence(host_.device, &fenceInfo, nullptr, &fence_), "vkCreateFence");
}

Engine::~Engine() {
  vkDestroyFence(host_.device, fence_, nullptr);
  vkDestroyCommandPool(host_.device, commands_, nullptr);
  for (const VkPipeline pipeline : pipelines_)
    vkDestroyPipeline(host_.device, pipeline, nullptr);
  vkDestroyDescriptorPool(host_.device, descriptors_, nullptr);
  vkDestroyPipelineLayout(host_.device, layout_, nullptr);
  vkDestroyDescriptorSetLayout(host_.device, setLayout_, nullptr);
  for (const Buffer &buffer : buffers_) {
    vkDestroyBuffer(host_.device, buffer.buffer, nullptr);
    vkFreeMemory(host_.device, buffer.memory, nullptr);
  }
  vkDestroyDevice(host_.device, nullptr);
  vkDestroyInstance(host_.instance, nullptr);
}

void Engine::openDevice() {
  const VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                      .pApplicationName = "host-device",
                                      .apiVersion = VK_API_VERSION_1_2};
  const VkInstanceCreateInfo instanceInfo{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                          .pApplicationInfo = &application};
  check(vkCreateInstance(&instanceInfo, nullptr, &host_.instance), "vkCreateInstance");
  std::uint32_t count = 1;
  vkEnumeratePhysicalDevices(host_.instance, &count, &host_.physicalDevice);
  if (count == 0)
    fail("there is no Vulkan device");
  vkGetPhysicalDeviceQueueFamilyProperties(host_.physicalDevice, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(host_.physicalDevice, &count, families.data());
  while (host_.queueFamily + 1 < count && !(families[host_.queueFamily].queueFlags & VK_QUEUE_COMPUTE_BIT))
    ++host_.queueFamily;

  // The device is opened with what kernels can use. An engine adds what it needs itself.
  const auto features = voxc::usefulFeatures(host_.instance, host_.physicalDevice);
  if (!features)
    fail(features.error().message.c_str());
  host_.features = *features;
  VkPhysicalDeviceBufferDeviceAddressFeatures addresses{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_BUFFER_DEVICE_ADDRESS_FEATURES,
      .bufferDeviceAddress = features->bufferDeviceAddress};
  const float priority = 1;
  const VkDeviceQueueCreateInfo queueInfo{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                          .queueFamilyIndex = host_.queueFamily,
                                          .queueCount = 1,
                                          .pQueuePriorities = &priority};
  const VkDeviceCreateInfo deviceInfo{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                      .pNext = &addresses,
                                      .queueCreateInfoCount = 1,
                                      .pQueueCreateInfos = &queueInfo,
                                      .pEnabledFeatures = &host_.features.core};
  check(vkCreateDevice(host_.physicalDevice, &deviceInfo, nullptr, &host_.device), "vkCreateDevice");
  vkGetDeviceQueue(host_.device, host_.queueFamily, 0, &host_.queue);
}

Engine::Buffer Engine::makeBuffer(VkDeviceSize bytes, VkBufferUsageFlags alsoFor) {
  Buffer buffer{.bytes = bytes};
  const VkBufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                .size = bytes,
                                .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | alsoFor};
  check(vkCreateBuffer(host_.device, &info, nullptr, &buffer.buffer), "vkCreateBuffer");
  VkMemoryRequirements needs;
  vkGetBufferMemoryRequirements(host_.device, buffer.buffer, &needs);
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(host_.physicalDevice, &memory);
  constexpr VkMemoryPropertyFlags kShared =
      VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  std::uint32_t type = 0; // Every device has one that both sides see.
  while ((memory.memoryTypes[type].propertyFlags & kShared) != kShared || !(needs.memoryTypeBits >> type & 1))
    ++type;
  const VkMemoryAllocateInfo allocation{
      .sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, .allocationSize = needs.size, .memoryTypeIndex = type};
  check(vkAllocateMemory(host_.device, &allocation, nullptr, &buffer.memory), "vkAllocateMemory");
  check(vkBindBufferMemory(host_.device, buffer.buffer, buffer.memory, 0), "vkBindBufferMemory");
  check(vkMapMemory(host_.device, buffer.memory, 0, bytes, 0, &buffer.mapped), "vkMapMemory");
  buffers_.push_back(buffer);
  return buffer;
}

void Engine::bind(std::span<const Buffer> buffers) {
  const auto count = static_cast<std::uint32_t>(buffers.size());
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (std::uint32_t binding = 0; binding < count; ++binding)
    bindings.push_back({.binding = binding,
                        .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                        .descriptorCount = 1,
                        .stageFlags = VK_SHADER_STAGE_COMPUTE_BIT});
  const VkDescriptorSetLayoutCreateInfo setInfo{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                                .bindingCount = count,
                                                .pBindings = bindings.data()};
  check(vkCreateDescriptorSetLayout(host_.device, &setInfo, nullptr, &setLayout_),
        "vkCreateDescriptorSetLayout");
  const VkPipelineLayoutCreateInfo layoutInfo{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                              .setLayoutCount = 1,
                                              .pSetLayouts = &setLayout_};
  check(vkCreatePipelineLayout(host_.device, &layoutInfo, nullptr, &layout_), "vkCreatePipelineLayout");
  const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, count};
  const VkDescriptorPoolCreateInfo poolInfo{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                            .maxSets = 1,
                                            .poolSizeCount = 1,
                                            .pPoolSizes = &size};
  check(vkCreateDescriptorPool(host_.device, &poolInfo, nullptr, &descriptors_), "vkCreateDescriptorPool");
  const VkDescriptorSetAllocateInfo allocation{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                               .descriptorPool = descriptors_,
                                               .descriptorSetCount = 1,
                                               .pSetLayouts = &setLayout_};
  check(vkAllocateDescriptorSets(host_.device, &allocation, &set_), "vkAllocateDescriptorSets");
  for (std::uint32_t binding = 0; binding < count; ++binding) {
    const VkDescriptorBufferInfo buffer{buffers[binding].buffer, 0, VK_WHOLE_SIZE};
    const VkWriteDescriptorSet write{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                     .dstSet = set_,
                                     .dstBinding = binding,
                                     .descriptorCount = 1,
                                     .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                     .pBufferInfo = &buffer};
    vkUpdateDescriptorSets(host_.device, 1, &write, 0, nullptr);
  }
}

VkPipeline Engine::makePipeline(std::span<const std::uint32_t> spirv) {
  const VkShaderModuleCreateInfo moduleInfo{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                            .codeSize = spirv.size_bytes(),
                                            .pCode = spirv.data()};
  VkShaderModule module = VK_NULL_HANDLE;
  check(vkCreateShaderModule(host_.device, &moduleInfo, nullptr, &module), "vkCreateShaderModule");
  const VkComputePipelineCreateInfo info{
      .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
      .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                .module = module,
                .pName = "main"},
      .layout = layout_};
  VkPipeline pipeline = VK_NULL_HANDLE;
  check(vkCreateComputePipelines(host_.device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
        "vkCreateComputePipelines");
  vkDestroyShaderModule(host_.device, module, nullptr);
  pipelines_.push_back(pipeline);
  return pipeline;
}

void Engine::dispatch(VkCommandBuffer commands, VkPipeline pipeline, std::uint32_t x, std::uint32_t y,
                      std::uint32_t z) const {
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 1, &set_, 0, nullptr);
  vkCmdDispatch(commands, x, y, z);
}

void Engine::barrier(VkCommandBuffer commands, VkPipelineStageFlags stage, VkAccessFlags access) {
  const VkMemoryBarrier barrier{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                .srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT,
                                .dstAccessMask = access};
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, stage, 0, 1, &barrier, 0, nullptr, 0,
                       nullptr);
}

void Engine::drawFrame(const std::function<void(VkCommandBuffer)> &record) {
  check(vkResetCommandPool(host_.device, commands_, VK_COMMAND_POOL_RESET_RELEASE_RESOURCES_BIT),
        "vkResetCommandPool");
  const VkCommandBufferAllocateInfo info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                         .commandPool = commands_,
                                         .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                         .commandBufferCount = 1};
  VkCommandBuffer commands = VK_NULL_HANDLE;
  check(vkAllocateCommandBuffers(host_.device, &info, &commands), "vkAllocateCommandBuffers");
  const VkCommandBufferBeginInfo begin{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
  record(commands);
  check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
  const VkSubmitInfo submit{
      .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands};
  check(vkQueueSubmit(host_.queue, 1, &submit, fence_), "vkQueueSubmit");
  check(vkWaitForFences(host_.device, 1, &fence_, VK_TRUE, UINT64_MAX), "vkWaitForFences");
  check(vkResetFences(host_.device, 1, &fence_), "vkResetFences");
  vkFreeCommandBuffers(host_.device, commands_, 1, &commands);
}
