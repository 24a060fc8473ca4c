// Which formats of a space are worth measuring, found by rating those near the frontier and what rewrites
// make of them, until that brings nothing more.
#pragma once

#include "voxc/Search/FormatPredictor.h"
#include "voxc/Search/Suggest.h"

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace voxc {

struct ExploreOptions {
  std::size_t maxLevels = 4;
  std::size_t mostFormats = 6000; ///< That are rated, but for seeds.
  /// Wall time that rating may take, and as much again for simulating all rays. If it ends the exploring,
  /// what was found depends on the machine.
  double seconds = std::numeric_limits<double>::infinity();
  /// Rays of each set that are simulated; those of all are, where a format comes near the frontier.
  std::size_t sampledRays = 192;
  /// Formats that take up to so many times the time of the frontier at their size are near it.
  double near = 1.15;
  double simulated = 1.3; ///< Of those up to so many times all rays are simulated,
  double kept = 1.6;      ///< and those up to so many times are returned.
};

/// What was found, and how much was looked at.
struct Explored {
  std::vector<PredictedFormat>
      formats;             ///< In the order in which they were found; each differs from all others.
  std::size_t rated = 0;   ///< Formats that were rated in all.
  bool isComplete = false; ///< No rewrite of what is near the frontier was left.
};

/// Begins with `seeds`, all of which are rated. The same for the same arguments, if there is time. Stops
/// early, with what it has, if asked to.
Explored explore(FormatPredictor &predictor, std::vector<Candidate> seeds, const CandidateTraits &traits,
                 std::span<const RaySet> rays, const SpeedModel &model, const Wish &wish,
                 const ExploreOptions &options = {}, const Progress &progress = {});

} // namespace voxc
