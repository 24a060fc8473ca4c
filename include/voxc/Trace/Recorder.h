// Traces that a program records into its own command buffers: between its own buffers, without a copy, a
// submission or a wait. What stands here is destroyed before its device.
#pragma once

#include "voxc/Trace/HostDevice.h"
#include "voxc/Volume/WordRange.h"

#include <cstdint>
#include <memory>
#include <span>
#include <utility>

namespace voxc {

/// A stretch of a host's buffer.
struct BufferRange {
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceSize offset = 0; ///< A multiple of 16, and of the device's minStorageBufferOffsetAlignment.
  VkDeviceSize bytes = 0;
};

/// The words of a volume on a device, where kernels read them. Copies share them.
class DeviceVolume {
public:
  /// Copies them there: submits to the device's queue and waits, once. Errors: they do not fit the device in
  /// this addressing (`Environment`).
  static Expected<DeviceVolume> upload(Device &device, const Volume &volume, Addressing addressing);
  /// Says that they lie in a storage buffer of the host's, who has brought them there: `Volume::words()`, and
  /// room for as many more as a multiple of four needs (`bytesFor`). Error (`Usage`): there is less room.
  static Expected<DeviceVolume> in(const BufferRange &words, const Volume &volume);
  /// The same for a volume that will change: all of the range is its room, and what is bound to it goes on
  /// after `recordUpdate`.
  static Expected<DeviceVolume> withRoom(const BufferRange &room, const Volume &volume);

  /// The bytes that so many words take.
  static std::uint64_t bytesFor(std::uint64_t words);

  /// What a kernel of that addressing finds at its binding: the words, or the table of segments.
  BufferRange words() const;
  Addressing addressing() const;

  struct State;
  const std::shared_ptr<const State> &state() const { return state_; }

private:
  explicit DeviceVolume(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

/// Records into a command buffer, outside of a render pass, what brings the words of a volume `withRoom` to
/// those of `after`: `changed` says which are others, as `EditableVolume::takeChanges` does. They are copied
/// into the commands in pieces of 4 KiB at most, so that the volume may be edited on at once; traces that are
/// recorded before read the words as they were, and those after it as they are. The buffer needs
/// VK_BUFFER_USAGE_TRANSFER_DST_BIT. Returns the bytes. Errors: `after` is of other storage (`Input`); it has
/// more words than there is room for: the host takes a larger buffer
/// (`Usage`). Nothing is recorded then.
Expected<std::uint64_t> recordUpdate(Device &device, VkCommandBuffer commands, const DeviceVolume &volume,
                                     const Volume &after, std::span<const WordRange> changed);

/// Where a trace reads and writes: buffers of the host's, all with VK_BUFFER_USAGE_STORAGE_BUFFER_BIT.
struct TraceBuffers {
  BufferRange rays; ///< `Ray`s; `BoundedRay`s of a kernel that is `bounded`.
  BufferRange hits; ///< As many `Hit`s.
  /// For what one dispatch leaves to the next; also with TRANSFER_DST and INDIRECT_BUFFER. Of
  /// `scratchBytes` of the most rays that are to be traced side by side; with less, they are traced in as
  /// many parts. Traces that are recorded together must not share it.
  BufferRange scratch;
};

/// The bytes of scratch memory for so many rays.
std::uint64_t scratchBytes(std::uint64_t rays);

/// A kernel bound to a volume and buffers: a descriptor set. It keeps its recorder's pipelines and the volume
/// that was uploaded. Destroy when nothing that was recorded with it is still running. Copies share it.
class BoundTrace {
public:
  /// The most rays and hits that its buffers hold.
  std::uint32_t rays() const;

  struct State;
  const State &state() const { return *state_; }

private:
  friend class TraceRecorder;
  explicit BoundTrace(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

/// Rays of a bound trace that are to be recorded.
struct RecordedTrace {
  const BoundTrace *trace = nullptr;
  std::uint32_t rays = 0; ///< So many of the buffer's.
  std::uint32_t firstRay = 0;
};

struct RecorderOptions {
  bool countSteps = false; ///< Lookups into `Hit::steps`.
  float spread = 0;        ///< As in `TraceOptions`.
  /// So many more dispatches, for rays whose loops a device cuts short (`Loops::Cut`, which is only Mesa's
  /// llvmpipe). What is still unfinished then has a hit whose voxel[0] is below -1. Each costs next to
  /// nothing where no ray needs it.
  unsigned resumes = 1;
  VkPipelineCache pipelineCache = VK_NULL_HANDLE; ///< The host's, if it has one.
};

/// A kernel on a device, ready to be recorded; from any number of threads. Copies share it.
class TraceRecorder {
public:
  /// Compiles the kernel's pipelines. Errors: as of `createTracer`.
  static Expected<TraceRecorder> create(Device &device, const Kernel &kernel,
                                        const RecorderOptions &options = {});
  /// Errors: the kernel was made for other storage or another addressing (`Input`); a range is empty, too
  /// small, out of line or larger than a storage buffer may be (`Usage`).
  Expected<BoundTrace> bind(const DeviceVolume &volume, const TraceBuffers &buffers) const;

  struct State;
  const State &state() const { return *state_; }

private:
  explicit TraceRecorder(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

/// Records traces of one device, of any recorders, into a command buffer that is being recorded outside of a
/// render pass, for a queue that computes. They run side by side: no barrier stands between one and another.
///
/// Reads rays and words, and reads and writes hits, as storage buffers of compute shaders. The host's
/// barriers order that with what it does with them itself, before and after; scratch memory is in order by
/// itself. Error (`Usage`): more rays than a trace's buffers hold, or two traces with one scratch memory;
/// nothing is recorded then.
Expected<void> recordTraces(VkCommandBuffer commands, std::span<const RecordedTrace> traces);

/// Records one.
Expected<void> recordTrace(VkCommandBuffer commands, const RecordedTrace &trace);

} // namespace voxc
