// Traces through many instances of volumes that a program records into its own command buffers: the nearest
// hit of each ray among all, found on the device. What stands here is destroyed before its device.
#pragma once

#include "voxc/Support/Geometry.h"
#include "voxc/Trace/InstancedTracer.h"
#include "voxc/Trace/Recorder.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <memory>
#include <span>

namespace voxc {

/// A volume on the device, and the recorder of a kernel for it.
struct RecordedVolume {
  const TraceRecorder *recorder = nullptr; ///< Its pipelines are kept.
  const DeviceVolume *volume = nullptr;    ///< Its words are kept, where voxc has uploaded them.
};

/// A volume at a place in the world.
struct RecordedInstance {
  std::uint32_t volume = 0; ///< Its place in the list of volumes.
  Int3 extent;              ///< Of its format, in voxels: `volume.format().extent()`.
  glm::mat4 toWorld{1.0f};  ///< From its voxels to the world: affine, with an inverse.
};

struct InstancedRecorderOptions {
  /// Rays of the world are `BoundedRay`s. All kernels must take bounds then.
  bool boundedRays = false;
  /// In a round, each ray is traced through the next of the instances that it may hit: one in the first
  /// round, then two, four, and eight in each that follows. A round that no ray needs costs a few empty
  /// dispatches. What is unfinished after the last has a hit whose voxel[0] is below -1.
  unsigned rounds = 12;
  VkPipelineCache pipelineCache = VK_NULL_HANDLE; ///< The host's, if it has one.
};

/// Buffers that rays and hits are in, bound to a recorder. Destroy when nothing that was recorded with it is
/// still running. Copies share it.
class BoundInstancedTrace {
public:
  /// The most rays and hits that its buffers hold.
  std::uint32_t rays() const;

  struct State;
  const State &state() const { return *state_; }

private:
  friend class InstancedRecorder;
  explicit BoundInstancedTrace(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

/// Instances on a device, ready to be recorded. Hits are those of an `InstancedTracer`, bit by bit: float64
/// of the device takes rays to the voxels of instances, and rounds once. Copies share it.
class InstancedRecorder {
public:
  /// Builds a bounding-volume hierarchy over the instances and copies it to the device: submits to the
  /// device's queue and waits, once. Compiles a few pipelines. Errors (`Usage`): a volume or its recorder is
  /// null, an instance's volume is not in the list, a matrix is none of `InstancedTracer::create`'s, a kernel
  /// takes no bounds but rays have them; `Environment`: the device has no float64, or no room.
  static Expected<InstancedRecorder> create(Device &device, std::span<const RecordedVolume> volumes,
                                            std::span<const RecordedInstance> instances,
                                            const InstancedRecorderOptions &options = {});

  /// The bytes of scratch memory for so many rays. With less, they are traced in as many parts.
  std::uint64_t scratchBytes(std::uint64_t rays) const;

  /// `buffers.hits` are `InstanceHit`s; `scratch` is of `scratchBytes` of the most rays that are to be traced
  /// side by side, with the usages that `TraceBuffers` says. Errors: as of `TraceRecorder::bind`.
  Expected<BoundInstancedTrace> bind(const TraceBuffers &buffers) const;

  struct State;

private:
  explicit InstancedRecorder(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

/// Records a trace of so many rays of the bound buffers from `firstRay` on, into a command buffer that is
/// being recorded outside of a render pass, for a queue that computes. Barriers before and behind it are the
/// host's, as for `recordTraces`. Error (`Usage`): more rays than the buffers hold; nothing is recorded then.
Expected<void> recordInstancedTrace(VkCommandBuffer commands, const BoundInstancedTrace &trace,
                                    std::uint32_t rays, std::uint32_t firstRay = 0);

} // namespace voxc
