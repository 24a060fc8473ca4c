// A compute program on a device.
#include "Program.h"

#include "GpuState.h"

namespace voxc::gpu {
namespace {

Expected<OwnedSetLayout> makeSetLayout(VkDevice device, std::uint32_t bindings) {
  std::vector<VkDescriptorSetLayoutBinding> places;
  places.reserve(bindings);
  for (std::uint32_t i = 0; i < bindings; ++i)
    places.push_back({i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
  VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  info.bindingCount = bindings;
  info.pBindings = places.data();
  return make<OwnedSetLayout>(device, vkCreateDescriptorSetLayout, info, "describe buffers");
}

Expected<OwnedLayout> makeLayout(VkDevice device, VkDescriptorSetLayout set, std::uint32_t pushWords) {
  const VkPushConstantRange range{VK_SHADER_STAGE_COMPUTE_BIT, 0, pushWords * 4};
  VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  info.setLayoutCount = 1;
  info.pSetLayouts = &set;
  info.pushConstantRangeCount = 1;
  info.pPushConstantRanges = &range;
  return make<OwnedLayout>(device, vkCreatePipelineLayout, info, "describe a program");
}

/// The set's pool, which holds that set alone.
Expected<OwnedPool> makePool(VkDevice device, std::uint32_t bindings) {
  const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, bindings};
  VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  info.maxSets = 1;
  info.poolSizeCount = 1;
  info.pPoolSizes = &size;
  return make<OwnedPool>(device, vkCreateDescriptorPool, info, "bind buffers");
}

Expected<OwnedPipeline> makePipeline(const Gpu::State &state, std::span<const std::uint32_t> spirv,
                                     VkPipelineLayout layout, std::span<const ProgramConstant> constants) {
  VkShaderModuleCreateInfo moduleInfo{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  moduleInfo.codeSize = spirv.size_bytes();
  moduleInfo.pCode = spirv.data();
  const auto shader =
      VOXC_TRY(make<OwnedShader>(state.device, vkCreateShaderModule, moduleInfo, "take a program"));
  std::vector<VkSpecializationMapEntry> entries;
  for (const ProgramConstant &constant : constants)
    entries.push_back({constant.id,
                       static_cast<std::uint32_t>(entries.size() * sizeof(ProgramConstant) +
                                                  offsetof(ProgramConstant, value)),
                       sizeof constant.value});
  const VkSpecializationInfo specialization{static_cast<std::uint32_t>(entries.size()), entries.data(),
                                            constants.size_bytes(), constants.data()};
  VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  info.flags = state.facts.hasStatistics ? VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR : 0;
  info.stage = {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.module = shader.get();
  info.stage.pName = "main";
  info.stage.pSpecializationInfo = &specialization;
  info.layout = layout;
  VkPipeline made = VK_NULL_HANDLE;
  if (const VkResult result =
          vkCreateComputePipelines(state.device, VK_NULL_HANDLE, 1, &info, nullptr, &made);
      result != VK_SUCCESS)
    return gpuError("compile a program", result);
  return OwnedPipeline(state.device, made);
}

double valueOf(const VkPipelineExecutableStatisticKHR &figure) {
  switch (figure.format) {
  case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_BOOL32_KHR:
    return figure.value.b32;
  case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_INT64_KHR:
    return static_cast<double>(figure.value.i64);
  case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_UINT64_KHR:
    return static_cast<double>(figure.value.u64);
  default:
    return figure.value.f64;
  }
}

} // namespace

Expected<Program> Program::make(const Gpu &gpu, std::span<const std::uint32_t> spirv, std::uint32_t bindings,
                                std::uint32_t pushWords, std::span<const ProgramConstant> constants) {
  Program made;
  made.state_ = &gpu.state();
  const VkDevice device = made.state_->device;
  made.setLayout_ = VOXC_TRY(makeSetLayout(device, bindings));
  made.layout_ = VOXC_TRY(makeLayout(device, made.setLayout_.get(), pushWords));
  made.pool_ = VOXC_TRY(makePool(device, bindings));
  const VkDescriptorSetLayout setLayout = made.setLayout_.get();
  VkDescriptorSetAllocateInfo allocation{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  allocation.descriptorPool = made.pool_.get();
  allocation.descriptorSetCount = 1;
  allocation.pSetLayouts = &setLayout;
  if (const VkResult result = vkAllocateDescriptorSets(device, &allocation, &made.set_); result != VK_SUCCESS)
    return gpuError("bind buffers", result);
  made.pipeline_ = VOXC_TRY(makePipeline(*made.state_, spirv, made.layout_.get(), constants));
  return made;
}

void Program::bind(std::span<const GpuBuffer *const> buffers) const {
  std::vector<VkDescriptorBufferInfo> infos;
  for (const GpuBuffer *const buffer : buffers)
    infos.push_back({buffer->buffer.get(), 0, buffer->bytes});
  VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = set_;
  write.descriptorCount = static_cast<std::uint32_t>(infos.size());
  write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  write.pBufferInfo = infos.data();
  vkUpdateDescriptorSets(state_->device, 1, &write, 0, nullptr);
}

void Program::record(VkCommandBuffer commands, std::span<const std::uint32_t> words) const {
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_.get());
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_.get(), 0, 1, &set_, 0, nullptr);
  vkCmdPushConstants(commands, layout_.get(), VK_SHADER_STAGE_COMPUTE_BIT, 0,
                     static_cast<std::uint32_t>(words.size_bytes()), words.data());
}

std::vector<ProgramFigure> Program::figures() const {
  if (!state_->facts.hasStatistics)
    return {};
  const auto statistics = reinterpret_cast<PFN_vkGetPipelineExecutableStatisticsKHR>(
      vkGetDeviceProcAddr(state_->device, "vkGetPipelineExecutableStatisticsKHR"));
  VkPipelineExecutableInfoKHR info{VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR};
  info.pipeline = pipeline_.get();
  std::uint32_t count = 0;
  if (!statistics || statistics(state_->device, &info, &count, nullptr) != VK_SUCCESS)
    return {};
  std::vector<VkPipelineExecutableStatisticKHR> found(count,
                                                      {VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR});
  if (statistics(state_->device, &info, &count, found.data()) < VK_SUCCESS)
    return {};
  std::vector<ProgramFigure> figures;
  figures.reserve(found.size());
  for (const VkPipelineExecutableStatisticKHR &figure : found)
    figures.push_back({figure.name, valueOf(figure)});
  return figures;
}

} // namespace voxc::gpu
