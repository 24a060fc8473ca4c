// A kernel as Vulkan pipelines, and buffers that it reads and writes.
#pragma once

#include "Buffer.h"
#include "ComputeLayout.h"

#include "voxc/Trace/Kernel.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace voxc {

/// What a dispatch does, as the kernel knows it.
enum class Task : std::uint32_t {
  All = 0,      ///< All rays, from their beginning.
  Deferred = 1, ///< Goes on with those that the dispatch before has put on its list.
  CutOff = 2,   ///< Goes on with those that the device has cut off.
};

/// The rays of one dispatch: the kernel's push constants.
struct RayTile {
  std::uint32_t first = 0;
  std::uint32_t rayCount = 0;
  Task task = Task::All;
};

/// The bytes of the list of deferred rays, of a tile of so many.
constexpr std::uint64_t deferredListBytes(std::uint64_t rays) { return sizeof(std::uint32_t) * (4 + rays); }

/// What a kernel counts for each ray.
enum class Counted { Nothing, Lookups, Words };
inline constexpr std::size_t kCountedKinds = 3;

/// Where rays begin, for which a kernel is made ready. It traces others right too.
enum class Origins {
  Near,     ///< Within twice the volume's longest edge: the fewest instructions.
  Anywhere, ///< Farther away too, as fast.
};

/// The pages of a volume, for kernels of `Addressing::Paged`.
struct PageShape {
  std::uint32_t log2PageWords = 0;
  std::uint32_t pages = 0;
};

/// The kernel's specialization constants; those that a kernel does not have are ignored.
struct Constants {
  VkBool32 countLookups;
  float spread;
  VkBool32 countWords;
  VkBool32 exactFallback;
  VkBool32 comesNear;
  PageShape pages;
};

/// The buffers of the kernel's interface, in the order of their bindings: rays, hits, words or their table,
/// the list of a tile's rays that are left over, and of paged kernels the table of pages.
using KernelBuffers = std::array<VkDescriptorBufferInfo, 5>;

/// All of a buffer.
inline VkDescriptorBufferInfo wholeOf(const Buffer &buffer) { return {buffer.get(), 0, buffer.bytes()}; }

/// Buffers that are bound to a kernel.
struct BoundBuffers {
  BufferViewHandle texels; ///< Of the words, where kernels read them so.
  BoundSet set;
  VkDescriptorBufferInfo deferred{}; ///< The list.
};

/// Where a device finds the number of groups of a dispatch, if only it knows how many rays there are.
struct GroupsThere {
  VkBuffer buffer = VK_NULL_HANDLE; ///< Null: as many as the tile's rays need.
  VkDeviceSize offset = 0;
};

class TracePipeline {
public:
  static Expected<TracePipeline> create(Device::State &device, const Kernel &kernel, PageShape pages = {});

  Expected<BoundBuffers> bind(const KernelBuffers &buffers) const;

  /// Whether the variant that counts this is made already for this spread, and for rays that begin there.
  bool isPrepared(Counted counted, float spread, Origins origins) const {
    const Variant &variant = variants_[std::size_t(counted)];
    return variant.resolves && variant.spread == spread &&
           (variant.origins == Origins::Anywhere || origins == Origins::Near);
  }
  /// Makes a variant, in place of that for another spread or other origins; may compile for long. Nothing may
  /// be running. `cache` is a host's; without one it is the device's (`Device::useCache`).
  Expected<void> prepare(Counted counted, float spread, Origins origins = Origins::Anywhere,
                         VkPipelineCache cache = VK_NULL_HANDLE);

  /// Records the tracing of the bound rays [first, first + rayCount) by a prepared variant, in one dispatch
  /// that resolves what float32 cannot decide.
  void recordDispatch(VkCommandBuffer commands, const BoundBuffers &buffers, Counted counted,
                      const RayTile &tile, const GroupsThere &groups = {}) const;
  /// The same by two: one that resolves nothing exactly, and one over the rays which that defers.
  void recordDispatches(VkCommandBuffer commands, const BoundBuffers &buffers, Counted counted,
                        const RayTile &tile) const;

  /// The parts of that, between which there must be barriers: an empty list, one dispatch, and the other.
  void recordEmptyList(VkCommandBuffer commands, const BoundBuffers &buffers) const;
  void recordLeaving(VkCommandBuffer commands, const BoundBuffers &buffers, Counted counted,
                     const RayTile &tile, const GroupsThere &groups = {}) const;
  void recordDeferred(VkCommandBuffer commands, const BoundBuffers &buffers, Counted counted,
                      const RayTile &tile) const;

private:
  TracePipeline(Device::State &device, const Kernel &kernel, PageShape pages)
      : device_(&device), addressing_(kernel.addressing),
        bindings_(kernel.addressing == Addressing::Paged ? 5 : 4), pages_(pages) {
    if (device.cache)
      spirv_ = kernel.spirv;
  }
  VkDescriptorType typeOf(std::uint32_t binding) const;
  Expected<void> viewTexels(const VkDescriptorBufferInfo &words, BoundBuffers &bound) const;

  struct Variant {
    PipelineHandle defers;   ///< Defers the rays of which float32 cannot decide all.
    PipelineHandle resolves; ///< Traces every ray to its end.
    float spread = 0;
    Origins origins = Origins::Near;
  };

  Expected<PipelineHandle> createPipeline(const Constants &constants, VkPipelineCache cache);
  void start(VkCommandBuffer commands, const PipelineHandle &pipeline, const BoundBuffers &buffers,
             const RayTile &tile) const;
  void dispatch(VkCommandBuffer commands, const RayTile &tile, const GroupsThere &groups) const;

  Device::State *device_;
  Addressing addressing_;
  std::uint32_t bindings_; ///< Rays, hits, words or their table, the list of deferred rays; pages.
  PageShape pages_;
  std::vector<std::uint32_t> spirv_; ///< What pipelines are found by, where the device has a cache.
  ShaderModuleHandle module_;
  ComputeLayout layout_;
  Variant variants_[kCountedKinds]; ///< By what they count.
};

} // namespace voxc
