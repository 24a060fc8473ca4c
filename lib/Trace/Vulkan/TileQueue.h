// Runs a kernel over the rays on the device in tiles, so that no dispatch lasts long enough for a watchdog.
#pragma once

#include "Commands.h"
#include "Timestamps.h"
#include "TracePipeline.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>

namespace voxc {

/// One pass over the bound rays.
struct TilePass {
  const TracePipeline *pipeline = nullptr;
  const BoundBuffers *buffers = nullptr;
  Counted counted = Counted::Nothing;
  std::uint32_t rays = 0;
  std::uint32_t first = 0; ///< Of the bound rays.
  Task task = Task::All;
  bool resolvesAtOnce = false; ///< In one dispatch a tile, whatever the task.
  /// Called when a tile of so many rays is done; false ends the pass early.
  std::function<bool(std::uint32_t rays)> tileDone = [](std::uint32_t) { return true; };
};

/// Keeps two tiles in flight: the device works on one while the host records the next.
class TileQueue {
public:
  static Expected<TileQueue> create(Device::State &device);

  /// The most rays of a tile.
  std::uint32_t tileRays() const { return tileRays_; }

  /// Traces the rays and waits. Errors: `Interrupted` if the pass was ended early, or the device's.
  Expected<TraceTime> run(const TilePass &pass);

private:
  struct Slot {
    Commands commands;
    Timestamps timestamps;
    std::uint32_t raysInFlight = 0;
  };
  struct Span {
    std::optional<std::uint64_t> begin;
    std::uint64_t end = 0;
  };

  TileQueue(Device::State &device, std::array<Slot, 2> slots);
  static Expected<Slot> createSlot(Device::State &device);
  Expected<Span> runTiles(const TilePass &pass);
  Expected<void> start(Slot &slot, const TilePass &pass, std::uint32_t first, std::uint32_t count);
  Expected<void> finish(Slot &slot, const TilePass &pass, Span &span);

  Device::State *device_;
  std::array<Slot, 2> slots_; ///< Used in turn.
  std::uint32_t tileRays_;
};

} // namespace voxc
