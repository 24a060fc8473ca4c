// Shaders, their groups, and records.
#include "Pipeline.h"

#include "camera_rgen_spirv.h"
#include "mesh_rchit_spirv.h"
#include "missing_rchit_spirv.h"
#include "missing_rint_spirv.h"
#include "sky_rmiss_spirv.h"
#include "voxc_dag_rchit_spirv.h"
#include "voxc_dag_rint_spirv.h"
#include "voxc_grid_rchit_spirv.h"
#include "voxc_grid_rint_spirv.h"

#include <array>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <span>
#include <vector>

namespace {

struct Shader {
  VkShaderStageFlagBits stage;
  std::span<const std::uint32_t> words;
};

/// By their numbers in kGroups.
const Shader kShaders[] = {{VK_SHADER_STAGE_RAYGEN_BIT_KHR, camera_rgen_spirv},
                           {VK_SHADER_STAGE_MISS_BIT_KHR, sky_rmiss_spirv},
                           {VK_SHADER_STAGE_CLOSEST_HIT_BIT_KHR, mesh_rchit_spirv},
                           {VK_SHADER_STAGE_CLOSEST_HIT_BIT_KHR, missing_rchit_spirv},
                           {VK_SHADER_STAGE_INTERSECTION_BIT_KHR, missing_rint_spirv},
                           {VK_SHADER_STAGE_CLOSEST_HIT_BIT_KHR, voxc_dag_rchit_spirv},
                           {VK_SHADER_STAGE_INTERSECTION_BIT_KHR, voxc_dag_rint_spirv},
                           {VK_SHADER_STAGE_CLOSEST_HIT_BIT_KHR, voxc_grid_rchit_spirv},
                           {VK_SHADER_STAGE_INTERSECTION_BIT_KHR, voxc_grid_rint_spirv}};

struct Members {
  VkRayTracingShaderGroupTypeKHR type;
  std::uint32_t general = VK_SHADER_UNUSED_KHR, closest = VK_SHADER_UNUSED_KHR, within = VK_SHADER_UNUSED_KHR;
};

/// By Group.
constexpr Members kGroups[] = {
    {.type = VK_RAY_TRACING_SHADER_GROUP_TYPE_GENERAL_KHR, .general = 0},
    {.type = VK_RAY_TRACING_SHADER_GROUP_TYPE_GENERAL_KHR, .general = 1},
    {.type = VK_RAY_TRACING_SHADER_GROUP_TYPE_TRIANGLES_HIT_GROUP_KHR, .closest = 2},
    {.type = VK_RAY_TRACING_SHADER_GROUP_TYPE_PROCEDURAL_HIT_GROUP_KHR, .closest = 3, .within = 4},
    {.type = VK_RAY_TRACING_SHADER_GROUP_TYPE_PROCEDURAL_HIT_GROUP_KHR, .closest = 5, .within = 6},
    {.type = VK_RAY_TRACING_SHADER_GROUP_TYPE_PROCEDURAL_HIT_GROUP_KHR, .closest = 7, .within = 8}};

VkDeviceSize roundUp(VkDeviceSize value, VkDeviceSize step) { return (value + step - 1) / step * step; }

} // namespace

Pipeline::Pipeline(Device &device, std::uint32_t records) : device_(device), count_(records) {
  makeLayout();
  makePipeline();
  makeTable();
}

Pipeline::~Pipeline() {
  vkDestroyPipeline(device_.handle(), pipeline_, nullptr);
  vkDestroyPipelineLayout(device_.handle(), layout_, nullptr);
  vkDestroyDescriptorPool(device_.handle(), pool_, nullptr);
  vkDestroyDescriptorSetLayout(device_.handle(), setLayout_, nullptr);
}

void Pipeline::makeLayout() {
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (std::uint32_t binding = 0; binding < 4; ++binding)
    bindings.push_back({.binding = binding,
                        .descriptorType = binding == 0 ? VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR
                                                       : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                        .descriptorCount = 1,
                        .stageFlags = VK_SHADER_STAGE_RAYGEN_BIT_KHR | VK_SHADER_STAGE_CLOSEST_HIT_BIT_KHR});
  const VkDescriptorSetLayoutCreateInfo setInfo{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                                .bindingCount = 4,
                                                .pBindings = bindings.data()};
  check(vkCreateDescriptorSetLayout(device_.handle(), &setInfo, nullptr, &setLayout_),
        "vkCreateDescriptorSetLayout");
  const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR, 1},
                                        {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 3}};
  const VkDescriptorPoolCreateInfo poolInfo{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                            .maxSets = 1,
                                            .poolSizeCount = 2,
                                            .pPoolSizes = sizes};
  check(vkCreateDescriptorPool(device_.handle(), &poolInfo, nullptr, &pool_), "vkCreateDescriptorPool");
  const VkDescriptorSetAllocateInfo allocation{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                               .descriptorPool = pool_,
                                               .descriptorSetCount = 1,
                                               .pSetLayouts = &setLayout_};
  check(vkAllocateDescriptorSets(device_.handle(), &allocation, &set_), "vkAllocateDescriptorSets");
  const VkPipelineLayoutCreateInfo layoutInfo{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                              .setLayoutCount = 1,
                                              .pSetLayouts = &setLayout_};
  check(vkCreatePipelineLayout(device_.handle(), &layoutInfo, nullptr, &layout_), "vkCreatePipelineLayout");
}

void Pipeline::makePipeline() {
  std::vector<VkPipelineShaderStageCreateInfo> stages;
  for (const Shader &shader : kShaders) {
    const VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                        .codeSize = shader.words.size_bytes(),
                                        .pCode = shader.words.data()};
    VkShaderModule module = VK_NULL_HANDLE;
    check(vkCreateShaderModule(device_.handle(), &info, nullptr, &module), "vkCreateShaderModule");
    stages.push_back({.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                      .stage = shader.stage,
                      .module = module,
                      .pName = "main"});
  }
  std::vector<VkRayTracingShaderGroupCreateInfoKHR> groups;
  for (const Members &members : kGroups)
    groups.push_back({.sType = VK_STRUCTURE_TYPE_RAY_TRACING_SHADER_GROUP_CREATE_INFO_KHR,
                      .type = members.type,
                      .generalShader = members.general,
                      .closestHitShader = members.closest,
                      .anyHitShader = VK_SHADER_UNUSED_KHR,
                      .intersectionShader = members.within});
  const VkRayTracingPipelineCreateInfoKHR info{.sType =
                                                   VK_STRUCTURE_TYPE_RAY_TRACING_PIPELINE_CREATE_INFO_KHR,
                                               .stageCount = static_cast<std::uint32_t>(stages.size()),
                                               .pStages = stages.data(),
                                               .groupCount = static_cast<std::uint32_t>(groups.size()),
                                               .pGroups = groups.data(),
                                               .maxPipelineRayRecursionDepth = 1,
                                               .layout = layout_};
  check(device_.function<PFN_vkCreateRayTracingPipelinesKHR>("vkCreateRayTracingPipelinesKHR")(
            device_.handle(), VK_NULL_HANDLE, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_),
        "vkCreateRayTracingPipelinesKHR");
  for (const auto &stage : stages)
    vkDestroyShaderModule(device_.handle(), stage.module, nullptr);
}

void Pipeline::makeTable() {
  const auto &limits = device_.records();
  base_ = roundUp(limits.shaderGroupHandleSize, limits.shaderGroupBaseAlignment);
  stride_ =
      roundUp(limits.shaderGroupHandleSize + sizeof(VkDeviceAddress), limits.shaderGroupHandleAlignment);
  table_ = device_.makeBuffer(3 * base_ + count_ * stride_, VK_BUFFER_USAGE_SHADER_BINDING_TABLE_BIT_KHR);
  begin_ = roundUp(table_.address, limits.shaderGroupBaseAlignment) - table_.address;
  copyHandle(0, Group::Camera);
  copyHandle(base_, Group::Sky);
}

std::byte *Pipeline::at(VkDeviceSize offset) const {
  return static_cast<std::byte *>(table_.mapped) + begin_ + offset;
}

void Pipeline::copyHandle(VkDeviceSize offset, Group group) const {
  check(device_.function<PFN_vkGetRayTracingShaderGroupHandlesKHR>("vkGetRayTracingShaderGroupHandlesKHR")(
            device_.handle(), pipeline_, static_cast<std::uint32_t>(group), 1,
            device_.records().shaderGroupHandleSize, at(offset)),
        "vkGetRayTracingShaderGroupHandlesKHR");
}

void Pipeline::setRecord(std::uint32_t record, Group group, VkDeviceAddress words) {
  const VkDeviceSize offset = 2 * base_ + record * stride_;
  copyHandle(offset, group);
  std::memcpy(at(offset + device_.records().shaderGroupHandleSize), &words, sizeof words);
}

void Pipeline::bind(VkAccelerationStructureKHR world, const Buffer &rays, const Buffer &answers,
                    const Buffer &wanted) {
  const VkWriteDescriptorSetAccelerationStructureKHR structure{
      .sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET_ACCELERATION_STRUCTURE_KHR,
      .accelerationStructureCount = 1,
      .pAccelerationStructures = &world};
  const std::array buffers{VkDescriptorBufferInfo{rays.buffer, 0, VK_WHOLE_SIZE},
                           VkDescriptorBufferInfo{answers.buffer, 0, VK_WHOLE_SIZE},
                           VkDescriptorBufferInfo{wanted.buffer, 0, VK_WHOLE_SIZE}};
  const VkWriteDescriptorSet writes[] = {{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                          .pNext = &structure,
                                          .dstSet = set_,
                                          .dstBinding = 0,
                                          .descriptorCount = 1,
                                          .descriptorType = VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR},
                                         {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                          .dstSet = set_,
                                          .dstBinding = 1, // And on to the bindings behind it.
                                          .descriptorCount = buffers.size(),
                                          .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                          .pBufferInfo = buffers.data()}};
  vkUpdateDescriptorSets(device_.handle(), std::size(writes), writes, 0, nullptr);
}

void Pipeline::trace(VkCommandBuffer commands, std::uint32_t rays) const {
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_RAY_TRACING_KHR, pipeline_);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_RAY_TRACING_KHR, layout_, 0, 1, &set_, 0, nullptr);
  const VkDeviceAddress table = table_.address + begin_;
  const VkStridedDeviceAddressRegionKHR camera{table, base_, base_}, sky{table + base_, base_, base_},
      hits{table + 2 * base_, stride_, count_ * stride_}, none{};
  device_.function<PFN_vkCmdTraceRaysKHR>("vkCmdTraceRaysKHR")(commands, &camera, &sky, &hits, &none, rays, 1,
                                                               1);
  const VkMemoryBarrier barrier{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                .srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT,
                                .dstAccessMask = VK_ACCESS_HOST_READ_BIT};
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_RAY_TRACING_SHADER_BIT_KHR, VK_PIPELINE_STAGE_HOST_BIT, 0,
                       1, &barrier, 0, nullptr, 0, nullptr);
}
