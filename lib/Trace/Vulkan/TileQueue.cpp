// Runs a kernel over the rays on the device in tiles.
#include "TileQueue.h"

#include "Trace/Rays/Clock.h"

#include <algorithm>
#include <utility>

namespace voxc {
namespace {

// On a GPU both passes of a tile end with a few long rays, while most of it has nothing to do.
constexpr std::uint64_t kMaxTileRays = std::uint64_t{1} << 20;
constexpr std::uint64_t kMaxTileRaysOfGpu = std::uint64_t{1} << 22;

} // namespace

TileQueue::TileQueue(Device::State &device, std::array<Slot, 2> slots)
    : device_(&device), slots_(std::move(slots)) {
  std::uint64_t groups = device.physical.limits.maxComputeWorkGroupCount[0];
  const std::uint64_t most = device.info().kind == "cpu" ? kMaxTileRays : kMaxTileRaysOfGpu;
  tileRays_ = static_cast<std::uint32_t>(std::min(most, groups * kWorkgroupSize));
}

Expected<TileQueue> TileQueue::create(Device::State &device) {
  auto first = VOXC_TRY(createSlot(device));
  auto second = VOXC_TRY(createSlot(device));
  return TileQueue(device, {std::move(first), std::move(second)});
}

Expected<TileQueue::Slot> TileQueue::createSlot(Device::State &device) {
  auto commands = VOXC_TRY(Commands::create(device));
  auto timestamps = VOXC_TRY(Timestamps::create(device));
  return Slot{std::move(commands), std::move(timestamps)};
}

Expected<TraceTime> TileQueue::run(const TilePass &pass) {
  double wall = wallSeconds();
  double cpu = processCpuSeconds();
  auto span = VOXC_TRY(runTiles(pass));
  TraceTime time{.wall = wallSeconds() - wall, .cpu = processCpuSeconds() - cpu};
  time.device = Timestamps::seconds(*device_, span.begin.value_or(span.end), span.end);
  return time;
}

Expected<TileQueue::Span> TileQueue::runTiles(const TilePass &pass) {
  Span span;
  Expected<void> outcome;
  std::size_t turn = 0;
  for (std::uint32_t first = 0; outcome && first < pass.rays; first += tileRays_) {
    Slot &slot = slots_[turn++ % 2];
    outcome = finish(slot, pass, span);
    if (outcome)
      outcome = start(slot, pass, pass.first + first, std::min(tileRays_, pass.rays - first));
  }
  // Whatever happened, nothing may be in flight on return: the caller frees or reuses what it works on.
  for (std::size_t rest = 0; rest < slots_.size(); ++rest) {
    auto finished = finish(slots_[turn++ % 2], pass, span);
    if (outcome)
      outcome = std::move(finished);
  }
  if (!outcome)
    return outcome.error();
  return span;
}

Expected<void> TileQueue::start(Slot &slot, const TilePass &pass, std::uint32_t first, std::uint32_t count) {
  auto commands = VOXC_TRY(slot.commands.begin());
  slot.timestamps.recordBegin(commands);
  if (pass.resolvesAtOnce || pass.task != Task::All)
    pass.pipeline->recordDispatch(commands, *pass.buffers, pass.counted, {first, count, pass.task});
  else
    pass.pipeline->recordDispatches(commands, *pass.buffers, pass.counted, {first, count, pass.task});
  slot.timestamps.recordEnd(commands);
  if (first + count == pass.first + pass.rays)
    recordBarrier(*device_, commands);
  VOXC_TRY(slot.commands.submit());
  slot.raysInFlight = count;
  return {};
}

Expected<void> TileQueue::finish(Slot &slot, const TilePass &pass, Span &span) {
  std::uint32_t rays = std::exchange(slot.raysInFlight, 0);
  if (rays == 0)
    return {};
  VOXC_TRY(slot.commands.wait());
  auto ticks = VOXC_TRY(slot.timestamps.read());
  span.begin = span.begin.value_or(ticks.begin);
  span.end = ticks.end;
  if (!pass.tileDone(rays))
    return Error::interrupted();
  return {};
}

} // namespace voxc
