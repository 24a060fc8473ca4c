// The compute kernels of instances.
#include "InstanceKernels.h"

#include "advance_spirv.h"
#include "gather_spirv.h"
#include "select_spirv.h"
#include "start_spirv.h"

#include <cstddef>
#include <iterator>
#include <span>

namespace voxc {
namespace {

/// By their numbers.
constexpr std::span<const std::uint32_t> kModules[kInstanceKernels] = {select_spirv, start_spirv,
                                                                       gather_spirv, advance_spirv};

constexpr VkSpecializationMapEntry kInstanceConstants[] = {
    {0, offsetof(InstanceConstants, raysHaveBounds), sizeof(VkBool32)},
    {1, offsetof(InstanceConstants, loopsAreCut), sizeof(VkBool32)},
    {2, offsetof(InstanceConstants, stack), sizeof(std::uint32_t)},
    {3, offsetof(InstanceConstants, volumes), sizeof(std::uint32_t)},
};

} // namespace

Expected<InstanceKernels> InstanceKernels::create(const Device::State &device,
                                                  const InstanceConstants &constants, VkPipelineCache cache) {
  InstanceKernels kernels(device);
  std::array<VkDescriptorType, 4> bindings;
  bindings.fill(VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
  kernels.layout_ = VOXC_TRY(ComputeLayout::create(device, bindings, sizeof(InstanceRound)));
  const VkSpecializationInfo specialization{std::size(kInstanceConstants), kInstanceConstants,
                                            sizeof constants, &constants};
  for (std::size_t kernel = 0; kernel < kInstanceKernels; ++kernel) {
    auto module = VOXC_TRY(createModule(device, kModules[kernel]));
    kernels.pipelines_[kernel] =
        VOXC_TRY(kernels.layout_.createPipeline(module.get(), specialization, cache));
  }
  return kernels;
}

void InstanceKernels::start(VkCommandBuffer commands, InstanceKernel kernel, const BoundSet &bound,
                            const InstanceRound &round) const {
  layout_.start(commands, pipelines_[std::size_t(kernel)], bound, std::as_bytes(std::span(&round, 1)));
}

void InstanceKernels::record(VkCommandBuffer commands, InstanceKernel kernel, const BoundSet &bound,
                             const InstanceRound &round, std::uint32_t groups) const {
  start(commands, kernel, bound, round);
  device_->vk.CmdDispatch(commands, groups, 1, 1);
}

void InstanceKernels::record(VkCommandBuffer commands, InstanceKernel kernel, const BoundSet &bound,
                             const InstanceRound &round, VkBuffer groups, VkDeviceSize offset) const {
  start(commands, kernel, bound, round);
  device_->vk.CmdDispatchIndirect(commands, groups, offset);
}

} // namespace voxc
