// Traces that a program records into its own command buffers.
#include "voxc/Trace/Recorder.h"

#include "Capabilities.h"
#include "DeviceVolume.h"
#include "RecorderState.h"
#include "Trace/Kernel/KernelFit.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace voxc {

std::uint32_t BoundTrace::rays() const { return state_->rays; }

std::uint64_t scratchBytes(std::uint64_t rays) { return deferredListBytes(rays); }

VkDescriptorBufferInfo descriptorOf(const BufferRange &range) {
  return {range.buffer, range.offset, range.bytes};
}

namespace {
/// Kernels load four words at once.
constexpr VkDeviceSize kRecordAlignment = 16;
} // namespace

Expected<void> checkRange(const Device::State &device, std::string_view what, const BufferRange &range,
                          std::uint64_t leastBytes) {
  const VkPhysicalDeviceLimits &limits = device.physical.limits;
  const auto wrong = [&](const std::string &problem) {
    return Error::usage("the range of the " + std::string(what) + " " + problem);
  };
  if (range.buffer == VK_NULL_HANDLE)
    return wrong("has no buffer");
  const VkDeviceSize alignment = std::max(limits.minStorageBufferOffsetAlignment, kRecordAlignment);
  if (range.offset % alignment != 0)
    return wrong("begins at " + std::to_string(range.offset) + ", which is no multiple of " +
                 std::to_string(alignment));
  if (range.bytes < leastBytes)
    return wrong("has " + std::to_string(range.bytes) + " bytes, but at least " + std::to_string(leastBytes) +
                 " are needed");
  if (range.bytes > limits.maxStorageBufferRange)
    return wrong("has " + std::to_string(range.bytes) + " bytes, but " + device.info().name +
                 " reaches at most " + std::to_string(limits.maxStorageBufferRange) + " at once");
  return {};
}

namespace {

Expected<void> checkRanges(const Device::State &device, const DeviceVolume &volume,
                           const TraceBuffers &buffers, std::uint64_t bytesOfRay) {
  struct Row {
    std::string_view what;
    BufferRange range;
    std::uint64_t leastBytes;
  };
  const Row rows[] = {{"rays", buffers.rays, bytesOfRay},
                      {"hits", buffers.hits, sizeof(Hit)},
                      {"words", volume.words(), 1},
                      {"scratch memory", buffers.scratch, deferredListBytes(kWorkgroupSize)}};
  for (const Row &row : rows)
    VOXC_TRY(checkRange(device, row.what, row.range, row.leastBytes));
  return {};
}

/// The most rays of one dispatch that scratch memory of so many bytes allows.
std::uint32_t tileRaysOf(const Device::State &device, std::uint64_t scratch) {
  const std::uint64_t groups = device.physical.limits.maxComputeWorkGroupCount[0];
  const std::uint64_t listed = scratch / sizeof(std::uint32_t) - deferredListBytes(0) / sizeof(std::uint32_t);
  const std::uint64_t rays = std::min(groups * kWorkgroupSize, listed);
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(rays, std::numeric_limits<std::uint32_t>::max()));
}

} // namespace

Expected<TraceRecorder> TraceRecorder::create(Device &device, const Kernel &kernel,
                                              const RecorderOptions &options) {
  Device::State &state = device.state();
  if (kernel.addressing == Addressing::Texels)
    return Error::usage("this kernel reads words as texels, which a recorder does not bind: compile one with "
                        "addressing=buffer");
  VOXC_TRY(checkKernel(state.physical, kernel));
  auto pipeline = VOXC_TRY(TracePipeline::create(state, kernel));
  const Counted counted = options.countSteps ? Counted::Lookups : Counted::Nothing;
  if (auto prepared = pipeline.prepare(counted, options.spread, Origins::Anywhere, options.pipelineCache);
      !prepared)
    return prepared.error();
  const bool cuts = state.info().loops == Loops::Cut;
  return TraceRecorder(std::make_shared<State>(State{&state, std::move(pipeline), kernel.storageDigest,
                                                     kernel.addressing, counted, cuts ? options.resumes : 0,
                                                     kernel.bounded ? sizeof(BoundedRay) : sizeof(Ray)}));
}

Expected<BoundTrace> TraceRecorder::bind(const DeviceVolume &volume, const TraceBuffers &buffers) const {
  const DeviceVolume::State &words = *volume.state();
  VOXC_TRY(checkFit(state_->storageDigest, words.storageDigest, words.format, "spirv"));
  if (state_->addressing != words.addressing)
    return Error::input(
        "this kernel has addressing=" + std::string(toString(state_->addressing)) +
        ", but the volume's words were uploaded with addressing=" + std::string(toString(words.addressing)));
  const Device::State &device = *state_->device;
  VOXC_TRY(checkRanges(device, volume, buffers, state_->bytesOfRay));
  auto bound = VOXC_TRY(state_->pipeline.bind({descriptorOf(buffers.rays), descriptorOf(buffers.hits),
                                               descriptorOf(volume.words()), descriptorOf(buffers.scratch)}));
  const std::uint64_t rays =
      std::min(buffers.rays.bytes / state_->bytesOfRay, buffers.hits.bytes / sizeof(Hit));
  return BoundTrace(std::make_shared<BoundTrace::State>(
      BoundTrace::State{state_, volume.state(), std::move(bound), static_cast<std::uint32_t>(rays),
                        tileRaysOf(device, buffers.scratch.bytes)}));
}

namespace {

/// Which work is done before which, and what of its memory the latter sees.
struct Order {
  VkPipelineStageFlags before;
  VkAccessFlags written;
  VkPipelineStageFlags after;
  VkAccessFlags seen;
};

constexpr VkPipelineStageFlags kShader = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
constexpr VkPipelineStageFlags kStart = VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT;
constexpr VkPipelineStageFlags kUpdate = VK_PIPELINE_STAGE_TRANSFER_BIT;
constexpr VkAccessFlags kShaderUse = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT;

/// Scratch memory: what traced with it before, and that its list is emptied.
constexpr Order kBeforeEmptying = {kShader | kStart | kUpdate,
                                   VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT, kUpdate,
                                   VK_ACCESS_TRANSFER_WRITE_BIT};
constexpr Order kBeforeLeaving = {kUpdate, VK_ACCESS_TRANSFER_WRITE_BIT, kShader, kShaderUse};
constexpr Order kBeforeDeferred = {kShader, VK_ACCESS_SHADER_WRITE_BIT, kShader | kStart,
                                   kShaderUse | VK_ACCESS_INDIRECT_COMMAND_READ_BIT};
constexpr Order kBeforeResuming = {kShader, VK_ACCESS_SHADER_WRITE_BIT, kShader, kShaderUse};

/// One tile of each trace.
class TileRecorder {
public:
  TileRecorder(VkCommandBuffer commands, std::span<const RecordedTrace> traces)
      : commands_(commands), traces_(traces) {}

  /// Records tile `number` of every trace that has one; false if none has.
  bool record(std::uint64_t number) {
    tiles_.clear();
    for (const RecordedTrace &trace : traces_)
      add(trace, number);
    if (tiles_.empty())
      return false;
    barrier(kBeforeEmptying);
    for (const Tile &tile : tiles_)
      pipelineOf(tile).recordEmptyList(commands_, tile.trace->buffers);
    barrier(kBeforeLeaving);
    for (const Tile &tile : tiles_)
      pipelineOf(tile).recordLeaving(commands_, tile.trace->buffers, countedBy(tile), tile.rays);
    barrier(kBeforeDeferred);
    for (const Tile &tile : tiles_)
      pipelineOf(tile).recordDeferred(commands_, tile.trace->buffers, countedBy(tile), tile.rays);
    for (unsigned pass = 0; resume(pass); ++pass)
      ;
    return true;
  }

private:
  struct Tile {
    const BoundTrace::State *trace;
    RayTile rays;
  };

  static const TracePipeline &pipelineOf(const Tile &tile) { return tile.trace->recorder->pipeline; }
  static Counted countedBy(const Tile &tile) { return tile.trace->recorder->counted; }

  void add(const RecordedTrace &recorded, std::uint64_t number) {
    const BoundTrace::State &trace = recorded.trace->state();
    const std::uint64_t first = number * trace.tileRays;
    if (first >= recorded.rays)
      return;
    const auto offset = static_cast<std::uint32_t>(first);
    tiles_.push_back(
        {&trace, {recorded.firstRay + offset, std::min(trace.tileRays, recorded.rays - offset)}});
  }

  /// Goes on once more with rays that the device has cut off; false if no trace wants that.
  bool resume(unsigned pass) {
    bool any = false;
    for (const Tile &tile : tiles_) {
      if (pass >= tile.trace->recorder->resumes)
        continue;
      if (!any)
        barrier(kBeforeResuming);
      any = true;
      pipelineOf(tile).recordDispatch(commands_, tile.trace->buffers, countedBy(tile),
                                      {tile.rays.first, tile.rays.rayCount, Task::CutOff});
    }
    return any;
  }

  void barrier(const Order &order) const {
    VkMemoryBarrier memory{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
    memory.srcAccessMask = order.written;
    memory.dstAccessMask = order.seen;
    const Device::State &device = *traces_.front().trace->state().recorder->device;
    device.vk.CmdPipelineBarrier(commands_, order.before, order.after, 0, 1, &memory, 0, nullptr, 0, nullptr);
  }

  VkCommandBuffer commands_;
  std::span<const RecordedTrace> traces_;
  std::vector<Tile> tiles_; ///< Of the number at hand.
};

bool shareScratch(const BoundTrace::State &a, const BoundTrace::State &b) {
  const VkDescriptorBufferInfo &left = a.buffers.deferred, &right = b.buffers.deferred;
  return left.buffer == right.buffer && left.offset < right.offset + right.range &&
         right.offset < left.offset + left.range;
}

Expected<void> checkTraces(std::span<const RecordedTrace> traces) {
  for (const RecordedTrace &recorded : traces) {
    const BoundTrace::State &trace = recorded.trace->state();
    if (std::uint64_t{recorded.firstRay} + recorded.rays > trace.rays)
      return Error::usage("rays " + std::to_string(recorded.firstRay) + " to " +
                          std::to_string(std::uint64_t{recorded.firstRay} + recorded.rays) +
                          " are to be traced, but the buffers hold " + std::to_string(trace.rays));
    for (const RecordedTrace &other : traces.first(&recorded - traces.data()))
      if (shareScratch(trace, other.trace->state()))
        return Error::usage("two traces that are recorded together have one scratch memory");
  }
  return {};
}

} // namespace

Expected<void> recordTraces(VkCommandBuffer commands, std::span<const RecordedTrace> traces) {
  VOXC_TRY(checkTraces(traces));
  TileRecorder recorder(commands, traces);
  for (std::uint64_t tile = 0; recorder.record(tile); ++tile)
    ;
  return {};
}

Expected<void> recordTrace(VkCommandBuffer commands, const RecordedTrace &trace) {
  return recordTraces(commands, {&trace, 1});
}

} // namespace voxc
