// A tracer on a Vulkan device.
#pragma once

#include "RayBuffers.h"
#include "TileQueue.h"
#include "Trace/Rays/FittingRays.h"
#include "Transfer.h"
#include "VolumeWords.h"

#include <optional>

namespace voxc {

/// Streams rays through the device in batches that its buffers hold.
class VulkanTracer final : public Tracer {
public:
  static Expected<std::unique_ptr<Tracer>> create(Device::State &device, const Kernel &kernel,
                                                  const Volume &volume);

  Expected<TraceReport> trace(RaySpan rays, std::span<Hit> hits, const TraceOptions &options) override;
  Expected<UpdateReport> update(const Volume &before, const Volume &after) override;
  Expected<UpdateReport> follow(const Volume &after, std::span<const WordRange> changed) override;

private:
  struct Work;

  VulkanTracer(Device::State &device, std::uint64_t storageDigest, Transfer transfer, VolumeWords words,
               TracePipeline pipeline, TileQueue tiles, bool bounded, Int3 extent);
  Expected<void> reserve(std::uint64_t rays);
  Expected<void> bind(const RayBuffers &batch);
  Expected<UpdateReport> rebound(Expected<UpdateReport> report, const Volume &after, VkBuffer before);
  Expected<void> traceBatch(const RaySpan &rays, std::span<Hit> hits, Work &work);
  Expected<void> download(std::span<Hit> hits, Work &work);
  /// Goes on with rays that the device cut short (`Kernel`), until none is left.
  Expected<void> finishRays(std::span<Hit> hits, Work &work);
  Expected<void> warmUp(const RaySpan &rays, Work &work);

  Device::State *device_;
  std::uint64_t storageDigest_; ///< Of the kernel.
  Transfer transfer_;
  VolumeWords words_;
  std::optional<RayBuffers> batch_; ///< Made when first needed.
  TracePipeline pipeline_;
  BoundBuffers bound_; ///< Those, and the words.
  TileQueue tiles_;
  bool bounded_; ///< Rays have bounds.
  Int3 extent_;  ///< Of the volume.
  FittingRays fitting_;
};

} // namespace voxc
