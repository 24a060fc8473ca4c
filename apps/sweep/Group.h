// A group of cells with the same model and rays, whose volumes are in memory together and traced in turn.
#pragma once

#include "sweep/Cells.h"
#include "sweep/VolumeCache.h"

#include "voxc/Oracle/Oracle.h"
#include "voxc/Support/Progress.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace voxc::tool::bench {

/// A cell whose volume is there.
struct BuiltCell {
  Cell *cell;
  CachedVolume volume;
};

struct MeasureOptions {
  unsigned rounds = 5;
  unsigned threads = 0;          ///< Of devices that are this processor; 0: all.
  std::size_t check = 20000;     ///< Rays, evenly spread, on which errors, steps and words are found.
  double steady = kSteadySpread; ///< The spread up to which a speed is steady.
  Progress progress;             ///< Only to stop.
  std::function<void()> advance; ///< Called after each of `stepsOf` steps.
};

/// The rays of a group and what is known of them.
struct GroupRays {
  SampledRays sampled;
  const Oracle *oracle = nullptr; ///< Null: there was none to ask.
};

/// How often a group of so many cells calls `advance`.
std::size_t stepsOf(std::size_t cells, const MeasureOptions &options);

/// Traces the cells in turn and adds what is found to their records; a cell that cannot be traced fails
/// alone. `picture`, if it is not "", is the path of a picture to take from `camera` by the first cell that
/// can. Error: `Interrupted`, with which the records are as they were.
Expected<void> measure(std::span<const BuiltCell> builtCells, const GroupRays &rays,
                       const MeasureOptions &options, const std::string &picture, const Camera &camera);

} // namespace voxc::tool::bench
