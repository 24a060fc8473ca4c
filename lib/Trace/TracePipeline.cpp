// A kernel as Vulkan pipelines.
#include "TracePipeline.h"

#include <array>
#include <cstddef>
#include <iterator>

namespace voxc {
namespace {

/// The kernel's bindings: rays, hits, and words or their table.
constexpr std::uint32_t kBindings = 3;

constexpr VkPushConstantRange kPushRange{VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(RayTile)};

/// The kernel's specialization constants; those that a kernel does not have are ignored.
struct Constants {
  VkBool32 countLookups;
  float spread;
  VkBool32 countWords;
};

constexpr VkSpecializationMapEntry kConstantEntries[] = {
    {0, offsetof(Constants, countLookups), sizeof(Constants::countLookups)},
    {1, offsetof(Constants, spread), sizeof(Constants::spread)},
    {2, offsetof(Constants, countWords), sizeof(Constants::countWords)},
};

Expected<ShaderModuleHandle> createModule(const Device::State &device, std::span<const std::uint32_t> spirv) {
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = spirv.size_bytes();
  info.pCode = spirv.data();
  return createObject<ShaderModuleHandle>(device.device, vkCreateShaderModule, info, "take the kernel");
}

} // namespace

Expected<TracePipeline> TracePipeline::create(Device::State &device, const Kernel &kernel) {
  TracePipeline pipeline(device);
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
  std::array<VkDescriptorSetLayoutBinding, kBindings> bindings{};
  for (std::uint32_t index = 0; index < kBindings; ++index)
    bindings[index] = {index, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
  VkDescriptorSetLayoutCreateInfo setInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  setInfo.bindingCount = kBindings;
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
  VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, kBindings};
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

void TracePipeline::bindBuffers(const Buffer &rays, const Buffer &hits, const Buffer &words) {
  const Buffer *buffers[kBindings] = {&rays, &hits, &words};
  std::array<VkDescriptorBufferInfo, kBindings> infos{};
  std::array<VkWriteDescriptorSet, kBindings> writes{};
  for (std::uint32_t index = 0; index < kBindings; ++index) {
    infos[index] = {buffers[index]->get(), 0, buffers[index]->bytes()};
    writes[index].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    writes[index].dstSet = set_;
    writes[index].dstBinding = index;
    writes[index].descriptorCount = 1;
    writes[index].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    writes[index].pBufferInfo = &infos[index];
  }
  vkUpdateDescriptorSets(device_->device, kBindings, writes.data(), 0, nullptr);
}

Expected<void> TracePipeline::prepare(Counted counted, float spread) {
  const Constants constants{counted == Counted::Lookups, spread, counted == Counted::Words};
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
  variants_[std::size_t(counted)] = {PipelineHandle(device_->device, pipeline), spread};
  return {};
}

void TracePipeline::recordDispatch(VkCommandBuffer commands, Counted counted, const RayTile &tile) const {
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, variants_[std::size_t(counted)].pipeline.get());
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_.get(), 0, 1, &set_, 0, nullptr);
  vkCmdPushConstants(commands, layout_.get(), kPushRange.stageFlags, 0, sizeof tile, &tile);
  vkCmdDispatch(commands, (tile.rayCount + kWorkgroupSize - 1) / kWorkgroupSize, 1, 1);
}

} // namespace voxc
