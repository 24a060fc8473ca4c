// What a compute shader is bound to.
#include "ComputeLayout.h"

namespace voxc {

Expected<ComputeLayout> ComputeLayout::create(const Device::State &device,
                                              std::span<const VkDescriptorType> bindings,
                                              std::uint32_t pushBytes) {
  ComputeLayout made;
  made.device_ = &device;
  made.bindings_.assign(bindings.begin(), bindings.end());
  std::vector<VkDescriptorSetLayoutBinding> places;
  for (const VkDescriptorType type : bindings)
    places.push_back(
        {static_cast<std::uint32_t>(places.size()), type, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
  VkDescriptorSetLayoutCreateInfo setInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  setInfo.bindingCount = static_cast<std::uint32_t>(places.size());
  setInfo.pBindings = places.data();
  made.set_ = VOXC_TRY(createObject<SetLayoutHandle>(device, &VulkanFunctions::CreateDescriptorSetLayout,
                                                     setInfo, "create a descriptor layout"));
  const VkDescriptorSetLayout setLayout = made.set_.get();
  const VkPushConstantRange pushRange{VK_SHADER_STAGE_COMPUTE_BIT, 0, pushBytes};
  VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  info.setLayoutCount = 1;
  info.pSetLayouts = &setLayout;
  info.pushConstantRangeCount = 1;
  info.pPushConstantRanges = &pushRange;
  made.layout_ = VOXC_TRY(createObject<PipelineLayoutHandle>(device, &VulkanFunctions::CreatePipelineLayout,
                                                             info, "create a pipeline layout"));
  return made;
}

Expected<BoundSet> ComputeLayout::bind(std::span<const VkDescriptorBufferInfo> buffers,
                                       VkBufferView texels) const {
  std::vector<VkDescriptorPoolSize> sizes;
  sizes.reserve(bindings_.size());
  for (const VkDescriptorType type : bindings_)
    sizes.push_back({type, 1});
  VkDescriptorPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  poolInfo.maxSets = 1;
  poolInfo.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
  poolInfo.pPoolSizes = sizes.data();
  auto pool = VOXC_TRY(createObject<DescriptorPoolHandle>(*device_, &VulkanFunctions::CreateDescriptorPool,
                                                          poolInfo, "create a descriptor pool"));
  BoundSet bound{std::move(pool)};
  const VkDescriptorSetLayout layout = set_.get();
  VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  info.descriptorPool = bound.pool.get();
  info.descriptorSetCount = 1;
  info.pSetLayouts = &layout;
  if (VkResult result = device_->vk.AllocateDescriptorSets(device_->device, &info, &bound.set);
      result != VK_SUCCESS)
    return vulkanError("allocate a descriptor set", result);
  std::vector<VkWriteDescriptorSet> writes(bindings_.size());
  for (std::uint32_t index = 0; index < writes.size(); ++index) {
    writes[index].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    writes[index].dstSet = bound.set;
    writes[index].dstBinding = index;
    writes[index].descriptorCount = 1;
    writes[index].descriptorType = bindings_[index];
    writes[index].pBufferInfo = &buffers[index];
    writes[index].pTexelBufferView = &texels;
  }
  device_->vk.UpdateDescriptorSets(device_->device, static_cast<std::uint32_t>(writes.size()), writes.data(),
                                   0, nullptr);
  return bound;
}

Expected<PipelineHandle> ComputeLayout::createPipeline(VkShaderModule module,
                                                       const VkSpecializationInfo &constants,
                                                       VkPipelineCache cache) const {
  VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.module = module;
  info.stage.pName = "main";
  info.stage.pSpecializationInfo = &constants;
  info.layout = layout_.get();
  VkPipeline pipeline = VK_NULL_HANDLE;
  const VkResult result =
      device_->vk.CreateComputePipelines(device_->device, cache, 1, &info, nullptr, &pipeline);
  if (result != VK_SUCCESS)
    return vulkanError("compile the kernel", result);
  return PipelineHandle(*device_, pipeline);
}

void ComputeLayout::start(VkCommandBuffer commands, const PipelineHandle &pipeline, const BoundSet &bound,
                          std::span<const std::byte> push) const {
  const VulkanFunctions &vk = device_->vk;
  vk.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.get());
  vk.CmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_.get(), 0, 1, &bound.set, 0,
                           nullptr);
  vk.CmdPushConstants(commands, layout_.get(), VK_SHADER_STAGE_COMPUTE_BIT, 0,
                      static_cast<std::uint32_t>(push.size()), push.data());
}

Expected<ShaderModuleHandle> createModule(const Device::State &device, std::span<const std::uint32_t> spirv) {
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = spirv.size_bytes();
  info.pCode = spirv.data();
  return createObject<ShaderModuleHandle>(device, &VulkanFunctions::CreateShaderModule, info,
                                          "take the kernel");
}

} // namespace voxc
