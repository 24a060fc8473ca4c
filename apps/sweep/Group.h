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
  double steady = 0.1;           ///< The spread up to which a speed is steady.
  Progress progress;             ///< Only to stop.
  std::function<void()> advance; ///< Called after each of `stepsOf` steps.
};

/// The rays of a group and what is known of them.
struct GroupRays {
  std::vector<Ray> rays;
  std::vector<Ray> sample;        ///< Of them, evenly spread.
  std::vector<Hit> exact;         ///< The oracle's hits of the sample.
  const Oracle *oracle = nullptr; ///< Null: there was none to ask.
};

/// The rays with a sample of at most `count`; the oracle is still to be asked.
GroupRays makeGroupRays(std::vector<Ray> rays, std::size_t count);

/// The mean of the hits' steps, of which there is one at least.
double meanSteps(std::span<const Hit> hits);

ErrorPart partOf(const ErrorFigures &error);

/// How often a group of so many cells calls `advance`.
std::size_t stepsOf(std::size_t cells, const MeasureOptions &options);

/// Traces the cells in turn and adds what is found to their records; a cell that cannot be traced fails
/// alone. `picture`, if it is not "", is the path of a picture to take from `camera` by the first cell that
/// can. Error: `Interrupted`, with which the records are as they were.
Expected<void> measure(std::span<const BuiltCell> builtCells, const GroupRays &rays,
                       const MeasureOptions &options, const std::string &picture, const Camera &camera);

} // namespace voxc::tool::bench
