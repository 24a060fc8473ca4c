// A kernel as Vulkan pipelines.
#include "TracePipeline.h"

#include "Commands.h"

#include <array>
#include <cstddef>
#include <iterator>

namespace voxc {
namespace {

/// The most bindings that a kernel has.
constexpr std::uint32_t kMostBindings = 5;

constexpr VkPushConstantRange kPushRange{VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(RayTile)};

/// The kernel's specialization constants; those that a kernel does not have are ignored.
struct Constants {
  VkBool32 countLookups;
  float spread;
  VkBool32 countWords;
  VkBool32 settles;
  PageShape pages;
};

constexpr VkSpecializationMapEntry kConstantEntries[] = {
    {0, offsetof(Constants, countLookups), sizeof(Constants::countLookups)},
    {1, offsetof(Constants, spread), sizeof(Constants::spread)},
    {2, offsetof(Constants, countWords), sizeof(Constants::countWords)},
    {3, offsetof(Constants, settles), sizeof(Constants::settles)},
    {4, offsetof(Constants, pages.log2PageWords), sizeof(PageShape::log2PageWords)},
    {5, offsetof(Constants, pages.pages), sizeof(PageShape::pages)},
};

Expected<ShaderModuleHandle> createModule(const Device::State &device, std::span<const std::uint32_t> spirv) {
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = spirv.size_bytes();
  info.pCode = spirv.data();
  return createObject<ShaderModuleHandle>(device.device, vkCreateShaderModule, info, "take the kernel");
}

} // namespace

Expected<TracePipeline> TracePipeline::create(Device::State &device, const Kernel &kernel, PageShape pages) {
  TracePipeline pipeline(device, kernel.addressing == Addressing::Paged, pages);
  auto module = createModule(device, kernel.spirv);
  if (!module)
    return module.error();
  pipeline.module_ = std::move(*module);
  if (auto created = pipeline.createLayouts(); !created)
    return created.error();
  if (auto created = pipeline.createSet(); !created)
    return created.error();
  return pipeline;
}

Expected<void> TracePipeline::createLayouts() {
  std::array<VkDescriptorSetLayoutBinding, kMostBindings> bindings{};
  for (std::uint32_t index = 0; index < bindings_; ++index)
    bindings[index] = {index, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
  VkDescriptorSetLayoutCreateInfo setInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  setInfo.bindingCount = bindings_;
  setInfo.pBindings = bindings.data();
  auto setLayout = createObject<SetLayoutHandle>(device_->device, vkCreateDescriptorSetLayout, setInfo,
                                                 "create a descriptor layout");
  if (!setLayout)
    return setLayout.error();
  setLayout_ = std::move(*setLayout);
  VkDescriptorSetLayout set = setLayout_.get();
  VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  info.setLayoutCount = 1;
  info.pSetLayouts = &set;
  info.pushConstantRangeCount = 1;
  info.pPushConstantRanges = &kPushRange;
  auto layout = createObject<PipelineLayoutHandle>(device_->device, vkCreatePipelineLayout, info,
                                                   "create a pipeline layout");
  if (!layout)
    return layout.error();
  layout_ = std::move(*layout);
  return {};
}

Expected<void> TracePipeline::createSet() {
  VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, bindings_};
  VkDescriptorPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  poolInfo.maxSets = 1;
  poolInfo.poolSizeCount = 1;
  poolInfo.pPoolSizes = &size;
  auto pool = createObject<DescriptorPoolHandle>(device_->device, vkCreateDescriptorPool, poolInfo,
                                                 "create a descriptor pool");
  if (!pool)
    return pool.error();
  pool_ = std::move(*pool);
  VkDescriptorSetLayout layout = setLayout_.get();
  VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  info.descriptorPool = pool_.get();
  info.descriptorSetCount = 1;
  info.pSetLayouts = &layout;
  if (VkResult result = vkAllocateDescriptorSets(device_->device, &info, &set_); result != VK_SUCCESS)
    return vulkanError("allocate a descriptor set", result);
  return {};
}

void TracePipeline::bindBuffers(const Buffer &rays, const Buffer &hits, const Buffer &words,
                                const Buffer &left, const Buffer *pageTable) {
  const Buffer *buffers[kMostBindings] = {&rays, &hits, &words, &left, pageTable};
  left_ = left.get();
  std::array<VkDescriptorBufferInfo, kMostBindings> infos{};
  std::array<VkWriteDescriptorSet, kMostBindings> writes{};
  for (std::uint32_t index = 0; index < bindings_; ++index) {
    infos[index] = {buffers[index]->get(), 0, buffers[index]->bytes()};
    writes[index].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    writes[index].dstSet = set_;
    writes[index].dstBinding = index;
    writes[index].descriptorCount = 1;
    writes[index].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    writes[index].pBufferInfo = &infos[index];
  }
  vkUpdateDescriptorSets(device_->device, bindings_, writes.data(), 0, nullptr);
}

Expected<void> TracePipeline::prepare(Counted counted, float spread) {
  auto leaves = createPipeline(counted, spread, false);
  if (!leaves)
    return leaves.error();
  auto settles = createPipeline(counted, spread, true);
  if (!settles)
    return settles.error();
  variants_[std::size_t(counted)] = {std::move(*leaves), std::move(*settles), spread};
  return {};
}

Expected<PipelineHandle> TracePipeline::createPipeline(Counted counted, float spread, bool settles) {
  const Constants constants{counted == Counted::Lookups, spread, counted == Counted::Words, settles, pages_};
  VkSpecializationInfo specialization{std::size(kConstantEntries), kConstantEntries, sizeof constants,
                                      &constants};
  VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.module = module_.get();
  info.stage.pName = "main";
  info.stage.pSpecializationInfo = &specialization;
  info.layout = layout_.get();
  VkPipeline pipeline = VK_NULL_HANDLE;
  VkResult result = vkCreateComputePipelines(device_->device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline);
  if (result != VK_SUCCESS)
    return vulkanError("compile the kernel", result);
  return PipelineHandle(device_->device, pipeline);
}

void TracePipeline::bind(VkCommandBuffer commands, const PipelineHandle &pipeline,
                         const RayTile &tile) const {
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.get());
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_.get(), 0, 1, &set_, 0, nullptr);
  vkCmdPushConstants(commands, layout_.get(), kPushRange.stageFlags, 0, sizeof tile, &tile);
}

void TracePipeline::recordDispatch(VkCommandBuffer commands, Counted counted, const RayTile &tile) const {
  bind(commands, variants_[std::size_t(counted)].settles, tile);
  vkCmdDispatch(commands, (tile.rayCount + kWorkgroupSize - 1) / kWorkgroupSize, 1, 1);
}

void TracePipeline::recordDispatches(VkCommandBuffer commands, Counted counted, RayTile tile) const {
  // No group to start yet, and no ray on the list. The tile before may still be reading its own.
  constexpr std::array<std::uint32_t, 4> kEmptyList = {0, 1, 1, 0};
  recordBarrier(commands);
  vkCmdUpdateBuffer(commands, left_, 0, sizeof kEmptyList, kEmptyList.data());
  recordBarrier(commands);
  bind(commands, variants_[std::size_t(counted)].leaves, tile);
  vkCmdDispatch(commands, (tile.rayCount + kWorkgroupSize - 1) / kWorkgroupSize, 1, 1);
  recordBarrier(commands);
  tile.task = Task::LeftOver;
  bind(commands, variants_[std::size_t(counted)].settles, tile);
  vkCmdDispatchIndirect(commands, left_, 0);
}

} // namespace voxc
