// A kernel as Vulkan pipelines, with the buffers bound that it reads and writes.
#pragma once

#include "Buffer.h"

#include "voxc/Trace/Kernel.h"

#include <cstdint>
#include <span>

namespace voxc {

/// The rays of one dispatch: the kernel's push constants.
struct RayTile {
  std::uint32_t first = 0;
  std::uint32_t rayCount = 0;
  std::uint32_t resumes = 0; ///< 1: go on with those that an earlier dispatch left unfinished.
};

/// What a kernel counts for each ray.
enum class Counted { Nothing, Lookups, Words };
inline constexpr std::size_t kCountedKinds = 3;

class TracePipeline {
public:
  static Expected<TracePipeline> create(Device::State &device, const Kernel &kernel);

  /// Binds the buffers of the kernel's interface; nothing that uses the old ones may be running.
  void bindBuffers(const Buffer &rays, const Buffer &hits, const Buffer &words);

  /// Whether the variant that counts this is made already for this spread.
  bool isPrepared(Counted counted, float spread) const {
    const Variant &variant = variants_[std::size_t(counted)];
    return variant.pipeline && variant.spread == spread;
  }
  /// Makes a variant, in place of that for another spread; may compile for long. Nothing may be running.
  Expected<void> prepare(Counted counted, float spread);
  /// Records the tracing of the bound rays [first, first + rayCount) by a prepared variant.
  void recordDispatch(VkCommandBuffer commands, Counted counted, const RayTile &tile) const;

private:
  explicit TracePipeline(Device::State &device) : device_(&device) {}
  Expected<void> createLayouts();
  Expected<void> createSet();

  struct Variant {
    PipelineHandle pipeline;
    float spread = 0;
  };

  Device::State *device_;
  ShaderModuleHandle module_;
  SetLayoutHandle setLayout_;
  PipelineLayoutHandle layout_;
  DescriptorPoolHandle pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE; ///< Belongs to the pool.
  Variant variants_[kCountedKinds];      ///< By what they count.
};

} // namespace voxc
