// What a compute shader is bound to: one descriptor set of buffers, and push constants.
#pragma once

#include "Handle.h"

#include <cstdint>
#include <span>
#include <vector>

namespace voxc {

/// A descriptor set, which belongs to the pool.
struct BoundSet {
  DescriptorPoolHandle pool;
  VkDescriptorSet set = VK_NULL_HANDLE;
};

/// The layout of a set whose bindings are numbered from 0, and of pipelines that take it.
class ComputeLayout {
public:
  /// Empty, to be assigned to.
  ComputeLayout() = default;
  static Expected<ComputeLayout> create(const Device::State &device,
                                        std::span<const VkDescriptorType> bindings, std::uint32_t pushBytes);

  /// A set of these buffers, one for each binding; those that are read as texels have `texels` as their view.
  Expected<BoundSet> bind(std::span<const VkDescriptorBufferInfo> buffers,
                          VkBufferView texels = VK_NULL_HANDLE) const;

  /// A pipeline of a module's function "main". May compile for long.
  Expected<PipelineHandle> createPipeline(VkShaderModule module, const VkSpecializationInfo &constants,
                                          VkPipelineCache cache) const;

  /// Records that the following dispatches use this pipeline, set and push constants.
  void start(VkCommandBuffer commands, const PipelineHandle &pipeline, const BoundSet &bound,
             std::span<const std::byte> push) const;

private:
  const Device::State *device_ = nullptr;
  std::vector<VkDescriptorType> bindings_;
  SetLayoutHandle set_;
  PipelineLayoutHandle layout_;
};

/// A module of SPIR-V on a device.
Expected<ShaderModuleHandle> createModule(const Device::State &device, std::span<const std::uint32_t> spirv);

} // namespace voxc
