// The compute kernels between which the kernels of volumes trace the rays of instances:
// shaders-runtime/instances.
#pragma once

#include "Trace/Vulkan/ComputeLayout.h"

#include <array>
#include <cstdint>

namespace voxc {

/// The kernels of a round, in their order.
enum class InstanceKernel { Select, Start, Gather, Advance };
inline constexpr std::size_t kInstanceKernels = 4;

/// Their push constants.
struct InstanceRound {
  std::uint32_t firstRay;
  std::uint32_t tileRays;
  std::uint32_t mostRays;
  std::uint32_t round;
  std::uint32_t most; ///< 0, of `Advance`: no round follows.
};

/// Their specialization constants.
struct InstanceConstants {
  VkBool32 raysHaveBounds;
  VkBool32 loopsAreCut;
  std::uint32_t stack;
  std::uint32_t volumes;
};

class InstanceKernels {
public:
  static Expected<InstanceKernels> create(const Device::State &device, const InstanceConstants &constants,
                                          VkPipelineCache cache);

  /// Rays, hits, the world and scratch memory.
  Expected<BoundSet> bind(const std::array<VkDescriptorBufferInfo, 4> &buffers) const {
    return layout_.bind(buffers);
  }

  /// Records a dispatch of so many groups.
  void record(VkCommandBuffer commands, InstanceKernel kernel, const BoundSet &bound,
              const InstanceRound &round, std::uint32_t groups) const;
  /// Of as many as are found in a buffer.
  void record(VkCommandBuffer commands, InstanceKernel kernel, const BoundSet &bound,
              const InstanceRound &round, VkBuffer groups, VkDeviceSize offset) const;

private:
  explicit InstanceKernels(const Device::State &device) : device_(&device) {}
  void start(VkCommandBuffer commands, InstanceKernel kernel, const BoundSet &bound,
             const InstanceRound &round) const;

  const Device::State *device_;
  ComputeLayout layout_;
  std::array<PipelineHandle, kInstanceKernels> pipelines_;
};

} // namespace voxc
