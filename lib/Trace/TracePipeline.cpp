// A kernel as Vulkan pipelines.
#include "TracePipeline.h"

#include "Commands.h"
#include "PipelineCache.h"

#include <cstddef>
#include <iterator>

namespace voxc {
namespace {

/// The most bindings that a kernel has.
constexpr std::uint32_t kMostBindings = std::tuple_size_v<KernelBuffers>;

constexpr std::size_t kWords = 2;
constexpr std::size_t kLeft = 3;

constexpr VkPushConstantRange kPushRange{VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(RayTile)};

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
  return createObject<ShaderModuleHandle>(device, &VulkanFunctions::CreateShaderModule, info,
                                          "take the kernel");
}

template <typename T> std::string_view bytesOf(std::span<const T> values) {
  return {reinterpret_cast<const char *>(values.data()), values.size_bytes()};
}

std::uint32_t groupsOf(const RayTile &tile) { return (tile.rayCount + kWorkgroupSize - 1) / kWorkgroupSize; }

} // namespace

Expected<TracePipeline> TracePipeline::create(Device::State &device, const Kernel &kernel, PageShape pages) {
  TracePipeline pipeline(device, kernel, pages);
  auto module = createModule(device, kernel.spirv);
  if (!module)
    return module.error();
  pipeline.module_ = std::move(*module);
  if (auto created = pipeline.createLayouts(); !created)
    return created.error();
  return pipeline;
}

Expected<void> TracePipeline::createLayouts() {
  std::array<VkDescriptorSetLayoutBinding, kMostBindings> bindings{};
  for (std::uint32_t index = 0; index < bindings_; ++index)
    bindings[index] = {index, typeOf(index), 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
  VkDescriptorSetLayoutCreateInfo setInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  setInfo.bindingCount = bindings_;
  setInfo.pBindings = bindings.data();
  auto setLayout = createObject<SetLayoutHandle>(*device_, &VulkanFunctions::CreateDescriptorSetLayout,
                                                 setInfo, "create a descriptor layout");
  if (!setLayout)
    return setLayout.error();
  setLayout_ = std::move(*setLayout);
  VkDescriptorSetLayout set = setLayout_.get();
  VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  info.setLayoutCount = 1;
  info.pSetLayouts = &set;
  info.pushConstantRangeCount = 1;
  info.pPushConstantRanges = &kPushRange;
  auto layout = createObject<PipelineLayoutHandle>(*device_, &VulkanFunctions::CreatePipelineLayout, info,
                                                   "create a pipeline layout");
  if (!layout)
    return layout.error();
  layout_ = std::move(*layout);
  return {};
}

VkDescriptorType TracePipeline::typeOf(std::uint32_t binding) const {
  return binding == kWords && addressing_ == Addressing::Texels ? VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER
                                                                : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
}

Expected<void> TracePipeline::viewTexels(const VkDescriptorBufferInfo &words, BoundBuffers &bound) const {
  VkBufferViewCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO};
  info.buffer = words.buffer;
  info.format = VK_FORMAT_R32_UINT;
  info.offset = words.offset;
  // Room that a buffer has for edits may be more than a view shows.
  info.range = std::min(words.range, device_->info().maxTexelBufferBytes);
  auto view = createObject<BufferViewHandle>(*device_, &VulkanFunctions::CreateBufferView, info,
                                             "create a view of a volume's words");
  if (!view)
    return view.error();
  bound.texels = std::move(*view);
  return {};
}

Expected<void> TracePipeline::allocateSet(BoundBuffers &bound) const {
  std::array<VkDescriptorPoolSize, kMostBindings> sizes{};
  for (std::uint32_t index = 0; index < bindings_; ++index)
    sizes[index] = {typeOf(index), 1};
  VkDescriptorPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  poolInfo.maxSets = 1;
  poolInfo.poolSizeCount = bindings_;
  poolInfo.pPoolSizes = sizes.data();
  auto pool = createObject<DescriptorPoolHandle>(*device_, &VulkanFunctions::CreateDescriptorPool, poolInfo,
                                                 "create a descriptor pool");
  if (!pool)
    return pool.error();
  bound.pool = std::move(*pool);
  VkDescriptorSetLayout layout = setLayout_.get();
  VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  info.descriptorPool = bound.pool.get();
  info.descriptorSetCount = 1;
  info.pSetLayouts = &layout;
  if (VkResult result = device_->vk.AllocateDescriptorSets(device_->device, &info, &bound.set);
      result != VK_SUCCESS)
    return vulkanError("allocate a descriptor set", result);
  return {};
}

Expected<BoundBuffers> TracePipeline::bind(const KernelBuffers &buffers) const {
  BoundBuffers bound{.left = buffers[kLeft]};
  if (addressing_ == Addressing::Texels)
    if (auto viewed = viewTexels(buffers[kWords], bound); !viewed)
      return viewed.error();
  if (auto allocated = allocateSet(bound); !allocated)
    return allocated.error();
  const VkBufferView texels = bound.texels.get();
  std::array<VkWriteDescriptorSet, kMostBindings> writes{};
  for (std::uint32_t index = 0; index < bindings_; ++index) {
    writes[index].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    writes[index].dstSet = bound.set;
    writes[index].dstBinding = index;
    writes[index].descriptorCount = 1;
    writes[index].descriptorType = typeOf(index);
    writes[index].pBufferInfo = &buffers[index];
    writes[index].pTexelBufferView = &texels;
  }
  device_->vk.UpdateDescriptorSets(device_->device, bindings_, writes.data(), 0, nullptr);
  return bound;
}

Expected<void> TracePipeline::prepare(Counted counted, float spread, VkPipelineCache cache) {
  Constants constants{counted == Counted::Lookups, spread, counted == Counted::Words, false, pages_};
  const bool isKept = cache == VK_NULL_HANDLE && !spirv_.empty();
  const PipelineCache kept(*device_, isKept ? device_->cache : nullptr, bytesOf<std::uint32_t>(spirv_),
                           bytesOf<Constants>({&constants, 1}));
  cache = isKept ? kept.get() : cache;
  auto leaves = createPipeline(constants, cache);
  if (!leaves)
    return leaves.error();
  constants.settles = true;
  auto settles = createPipeline(constants, cache);
  if (!settles)
    return settles.error();
  kept.store();
  variants_[std::size_t(counted)] = {std::move(*leaves), std::move(*settles), spread};
  return {};
}

Expected<PipelineHandle> TracePipeline::createPipeline(const Constants &constants, VkPipelineCache cache) {
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
  VkResult result = device_->vk.CreateComputePipelines(device_->device, cache, 1, &info, nullptr, &pipeline);
  if (result != VK_SUCCESS)
    return vulkanError("compile the kernel", result);
  return PipelineHandle(*device_, pipeline);
}

void TracePipeline::start(VkCommandBuffer commands, const PipelineHandle &pipeline,
                          const BoundBuffers &buffers, const RayTile &tile) const {
  const VulkanFunctions &vk = device_->vk;
  vk.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.get());
  vk.CmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_.get(), 0, 1, &buffers.set, 0,
                           nullptr);
  vk.CmdPushConstants(commands, layout_.get(), kPushRange.stageFlags, 0, sizeof tile, &tile);
}

void TracePipeline::recordDispatch(VkCommandBuffer commands, const BoundBuffers &buffers, Counted counted,
                                   const RayTile &tile) const {
  start(commands, variants_[std::size_t(counted)].settles, buffers, tile);
  device_->vk.CmdDispatch(commands, groupsOf(tile), 1, 1);
}

void TracePipeline::recordDispatches(VkCommandBuffer commands, const BoundBuffers &buffers, Counted counted,
                                     const RayTile &tile) const {
  recordBarrier(*device_, commands); // The tile before may still be reading its list.
  recordEmptyList(commands, buffers);
  recordBarrier(*device_, commands);
  recordLeaving(commands, buffers, counted, tile);
  recordBarrier(*device_, commands);
  recordLeftOver(commands, buffers, counted, tile);
}

void TracePipeline::recordEmptyList(VkCommandBuffer commands, const BoundBuffers &buffers) const {
  // No group to start yet, and no ray on the list.
  constexpr std::array<std::uint32_t, 4> kEmptyList = {0, 1, 1, 0};
  device_->vk.CmdUpdateBuffer(commands, buffers.left.buffer, buffers.left.offset, sizeof kEmptyList,
                              kEmptyList.data());
}

void TracePipeline::recordLeaving(VkCommandBuffer commands, const BoundBuffers &buffers, Counted counted,
                                  const RayTile &tile) const {
  start(commands, variants_[std::size_t(counted)].leaves, buffers, tile);
  device_->vk.CmdDispatch(commands, groupsOf(tile), 1, 1);
}

void TracePipeline::recordLeftOver(VkCommandBuffer commands, const BoundBuffers &buffers, Counted counted,
                                   const RayTile &tile) const {
  start(commands, variants_[std::size_t(counted)].settles, buffers,
        {tile.first, tile.rayCount, Task::LeftOver});
  device_->vk.CmdDispatchIndirect(commands, buffers.left.buffer, buffers.left.offset);
}

} // namespace voxc
