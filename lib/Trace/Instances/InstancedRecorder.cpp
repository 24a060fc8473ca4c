// Traces through many instances that a program records into its own command buffers.
#include "voxc/Trace/InstancedRecorder.h"

#include "InstanceKernels.h"
#include "InstanceLayout.h"
#include "InstancePlaces.h"
#include "Trace/Vulkan/Commands.h"
#include "Trace/Vulkan/DeviceVolume.h"
#include "Trace/Vulkan/RecorderState.h"
#include "Trace/Vulkan/Transfer.h"

#include <algorithm>
#include <string>
#include <vector>

namespace voxc {

struct InstancedRecorder::State {
  const Device::State *device;
  InstanceKernels kernels;
  Buffer world;
  std::vector<TraceRecorder> recorders; ///< Of the volumes.
  std::vector<DeviceVolume> volumes;
  std::uint64_t bytesOfRay; ///< Of the world's.
  unsigned rounds;
};

struct BoundInstancedTrace::State {
  std::shared_ptr<const InstancedRecorder::State> recorder;
  BoundSet set;
  std::vector<BoundTrace> volumes; ///< To the parts of scratch memory that are theirs.
  BufferRange scratch;
  InstanceScratch layout;
  std::uint32_t rays;
};

std::uint32_t BoundInstancedTrace::rays() const { return state_->rays; }

namespace {

constexpr std::uint32_t kMostAtOnce = 8; ///< As in select.comp.

std::uint32_t groupsOf(std::uint64_t rays) {
  return static_cast<std::uint32_t>((rays + kWorkgroupSize - 1) / kWorkgroupSize);
}

Expected<void> checkVolumes(std::span<const RecordedVolume> volumes, bool boundedRays) {
  for (std::size_t number = 0; number < volumes.size(); ++number) {
    const auto wrong = [&](const char *problem) {
      return Error::usage("volume " + std::to_string(number) + " " + problem);
    };
    if (!volumes[number].recorder || !volumes[number].volume)
      return wrong("has no recorder, or no words on the device");
    if (boundedRays && volumes[number].recorder->state().bytesOfRay != sizeof(BoundedRay))
      return wrong("has a kernel without bounds, but the rays have some: compile it with bounds=yes");
  }
  return {};
}

/// The words of the world, of instances that were checked, and the most nodes that wait in its hierarchy.
struct World {
  std::vector<std::uint32_t> words;
  std::uint32_t stack;
};

Expected<World> worldOf(std::span<const RecordedVolume> volumes,
                        std::span<const RecordedInstance> instances) {
  std::vector<InstanceBox> boxes;
  std::vector<InstanceRecord> records;
  for (const RecordedInstance &instance : instances) {
    if (instance.volume >= volumes.size())
      return wrongInstance(records.size(), "is of a volume that is not in the list");
    const auto fromWorld = VOXC_TRY(fromWorldOf(instance.toWorld, records.size()));
    boxes.push_back(boxOf(glm::dmat4(instance.toWorld), fromWorld, instance.extent));
    records.push_back({fromWorld, instance.volume});
  }
  std::vector<std::uint32_t> wordsOfRays;
  for (const RecordedVolume &volume : volumes)
    wordsOfRays.push_back(static_cast<std::uint32_t>(volume.recorder->state().bytesOfRay / 4));
  const InstanceTree tree(boxes);
  return World{worldWords(tree, wordsOfRays, records), tree.mostStacked()};
}

Expected<Buffer> uploadWorld(Device::State &device, std::span<const std::uint32_t> words) {
  auto transfer = VOXC_TRY(Transfer::create(device));
  auto buffer = VOXC_TRY(Buffer::create(device, {.what = "the instances", .bytes = words.size_bytes()}));
  VOXC_TRY(transfer.upload(std::as_bytes(words), buffer));
  return buffer;
}

} // namespace

Expected<InstancedRecorder> InstancedRecorder::create(Device &device, std::span<const RecordedVolume> volumes,
                                                      std::span<const RecordedInstance> instances,
                                                      const InstancedRecorderOptions &options) {
  Device::State &state = device.state();
  VOXC_TRY(checkVolumes(volumes, options.boundedRays));
  if (instances.size() >= InstanceTree::kLeaf)
    return Error::usage("there are " + std::to_string(instances.size()) + " instances, which are too many");
  if (!state.physical.features.shaderFloat64)
    return Error::environment(
        state.info().name +
        " has no float64 (shaderFloat64), by which rays are taken to instances: use an InstancedTracer");
  auto world = VOXC_TRY(worldOf(volumes, instances));
  auto buffer = VOXC_TRY(uploadWorld(state, world.words));
  auto kernels = VOXC_TRY(InstanceKernels::create(state,
                                                  {options.boundedRays, state.info().loops == Loops::Cut,
                                                   world.stack, static_cast<std::uint32_t>(volumes.size())},
                                                  options.pipelineCache));
  State made{&state,
             std::move(kernels),
             std::move(buffer),
             {},
             {},
             options.boundedRays ? sizeof(BoundedRay) : sizeof(Ray),
             std::max(options.rounds, 1u)};
  for (const RecordedVolume &volume : volumes) {
    made.recorders.push_back(*volume.recorder);
    made.volumes.push_back(*volume.volume);
  }
  return InstancedRecorder(std::make_shared<const State>(std::move(made)));
}

std::uint64_t InstancedRecorder::scratchBytes(std::uint64_t rays) const {
  return InstanceScratch{state_->volumes.size(), (rays + 63) / 64 * 64}.all() * sizeof(std::uint32_t);
}

Expected<BoundInstancedTrace> InstancedRecorder::bind(const TraceBuffers &buffers) const {
  const Device::State &device = *state_->device;
  struct Row {
    std::string_view what;
    BufferRange range;
    std::uint64_t leastBytes;
  };
  for (const Row &row :
       {Row{"rays", buffers.rays, state_->bytesOfRay}, Row{"hits", buffers.hits, sizeof(InstanceHit)},
        Row{"scratch memory", buffers.scratch, scratchBytes(1)}})
    VOXC_TRY(checkRange(device, row.what, row.range, row.leastBytes));
  auto layout =
      InstanceScratch::within(buffers.scratch.bytes / sizeof(std::uint32_t), state_->volumes.size());
  const std::uint64_t most = device.physical.limits.maxComputeWorkGroupCount[0];
  layout.tileRays = std::min(layout.tileRays, most * kWorkgroupSize);
  auto set =
      VOXC_TRY(state_->kernels.bind({descriptorOf(buffers.rays), descriptorOf(buffers.hits),
                                     VkDescriptorBufferInfo{state_->world.get(), 0, state_->world.bytes()},
                                     descriptorOf(buffers.scratch)}));
  const auto part = [&](std::uint64_t at, std::uint64_t words) {
    return BufferRange{buffers.scratch.buffer, buffers.scratch.offset + at * sizeof(std::uint32_t),
                       words * sizeof(std::uint32_t)};
  };
  std::vector<BoundTrace> volumes;
  for (std::size_t number = 0; number < state_->volumes.size(); ++number) {
    auto bound = VOXC_TRY(state_->recorders[number].bind(
        state_->volumes[number],
        {part(layout.rays(number), 8 * layout.tileRays), part(layout.hits(number), 6 * layout.tileRays),
         part(layout.deferred(number), layout.tileRays + 64)}));
    volumes.push_back(std::move(bound));
  }
  const std::uint64_t rays =
      std::min(buffers.rays.bytes / state_->bytesOfRay, buffers.hits.bytes / sizeof(InstanceHit));
  return BoundInstancedTrace(std::make_shared<BoundInstancedTrace::State>(
      BoundInstancedTrace::State{state_, std::move(set), std::move(volumes), buffers.scratch, layout,
                                 static_cast<std::uint32_t>(rays)}));
}

namespace {

/// Rays that are traced side by side.
class TileOfInstances {
public:
  TileOfInstances(VkCommandBuffer commands, const BoundInstancedTrace::State &trace, std::uint32_t first,
                  std::uint32_t rays)
      : commands_(commands), trace_(trace), recorder_(*trace.recorder),
        round_{first, rays, static_cast<std::uint32_t>(trace.layout.tileRays), 0, 1} {}

  void record() {
    empty();
    for (; round_.round < recorder_.rounds;
         ++round_.round, round_.most = std::min(2 * round_.most, kMostAtOnce)) {
      overRays(InstanceKernel::Select);
      oneGroup(InstanceKernel::Start);
      traceVolumes();
      overRays(InstanceKernel::Gather);
      oneGroup(InstanceKernel::Advance);
    }
    round_.most = 0;
    overRays(InstanceKernel::Advance);
  }

private:
  VkDeviceSize placeOf(std::uint64_t word) const {
    return trace_.scratch.offset + word * sizeof(std::uint32_t);
  }
  void barrier() const { recordBarrier(*recorder_.device, commands_); }

  /// No rays are before the kernels, and none on the lists.
  void empty() const {
    constexpr std::size_t kMostOfUpdate = 65536 / sizeof(std::uint32_t);
    const std::vector<std::uint32_t> zeros(trace_.layout.header());
    barrier();
    for (std::size_t first = 0; first < zeros.size(); first += kMostOfUpdate)
      recorder_.device->vk.CmdUpdateBuffer(
          commands_, trace_.scratch.buffer, placeOf(first),
          std::min(kMostOfUpdate, zeros.size() - first) * sizeof(std::uint32_t), zeros.data());
    barrier();
  }

  /// Over the rays that are not done, which at first are all.
  void overRays(InstanceKernel kernel) const {
    if (round_.round == 0)
      recorder_.kernels.record(commands_, kernel, trace_.set, round_, groupsOf(round_.tileRays));
    else
      recorder_.kernels.record(commands_, kernel, trace_.set, round_, trace_.scratch.buffer,
                               placeOf(InstanceScratch::activeGroups()));
    barrier();
  }

  void oneGroup(InstanceKernel kernel) const {
    recorder_.kernels.record(commands_, kernel, trace_.set, round_, 1);
    barrier();
  }

  void traceVolumes() const {
    forVolumes([&](const BoundTrace::State &trace, const RayTile &, const GroupsThere &) {
      trace.recorder->pipeline.recordEmptyList(commands_, trace.buffers);
    });
    forVolumes([&](const BoundTrace::State &trace, const RayTile &tile, const GroupsThere &groups) {
      trace.recorder->pipeline.recordLeaving(commands_, trace.buffers, trace.recorder->counted, tile, groups);
    });
    forVolumes([&](const BoundTrace::State &trace, const RayTile &tile, const GroupsThere &) {
      trace.recorder->pipeline.recordDeferred(commands_, trace.buffers, trace.recorder->counted, tile);
    });
    for (unsigned pass = 0; pass < mostResumes(); ++pass)
      forVolumes([&](const BoundTrace::State &trace, const RayTile &tile, const GroupsThere &groups) {
        if (pass < trace.recorder->resumes)
          trace.recorder->pipeline.recordDispatch(commands_, trace.buffers, trace.recorder->counted,
                                                  {tile.first, tile.rayCount, Task::CutOff}, groups);
      });
  }

  unsigned mostResumes() const {
    unsigned most = 0;
    for (const BoundTrace &trace : trace_.volumes)
      most = std::max(most, trace.state().recorder->resumes);
    return most;
  }

  /// Side by side, and a barrier behind them.
  template <typename Record> void forVolumes(const Record &record) const {
    for (std::size_t number = 0; number < trace_.volumes.size(); ++number)
      record(trace_.volumes[number].state(), RayTile{0, round_.mostRays},
             GroupsThere{trace_.scratch.buffer, placeOf(trace_.layout.starts(number))});
    barrier();
  }

  VkCommandBuffer commands_;
  const BoundInstancedTrace::State &trace_;
  const InstancedRecorder::State &recorder_;
  InstanceRound round_;
};

} // namespace

Expected<void> recordInstancedTrace(VkCommandBuffer commands, const BoundInstancedTrace &trace,
                                    std::uint32_t rays, std::uint32_t firstRay) {
  const BoundInstancedTrace::State &state = trace.state();
  if (std::uint64_t{firstRay} + rays > state.rays)
    return Error::usage("rays " + std::to_string(firstRay) + " to " +
                        std::to_string(std::uint64_t{firstRay} + rays) +
                        " are to be traced, but the buffers hold " + std::to_string(state.rays));
  const auto tileRays = static_cast<std::uint32_t>(state.layout.tileRays);
  for (std::uint64_t first = 0; first < rays; first += tileRays)
    TileOfInstances(commands, state, firstRay + static_cast<std::uint32_t>(first),
                    std::min(tileRays, rays - static_cast<std::uint32_t>(first)))
        .record();
  return {};
}

} // namespace voxc
