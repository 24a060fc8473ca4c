// Hard rays through many formats, scenes and devices: the loops, ordered so that the oracle answers once for
// each scene and set of rays.
#pragma once

#include "hard-rays/HardRayBudget.h"
#include "hard-rays/HardRayReport.h"
#include "hard-rays/HardRayScenes.h"

#include "tracing/TracingDevices.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/Stopwatch.h"

#include <map>
#include <string>
#include <vector>

namespace voxc::tool {

/// How much is done.
struct SweepSize {
  std::uint64_t rays = 0; ///< Over all formats, scenes and devices.
  double seconds = 0;     ///< Above 0: all of it again, with other rays, until so much time has passed.
  std::uint64_t seed = 1; ///< Another number makes other rays.
  std::size_t scenes = 0; ///< For each format, taking turns; 0: all.
  bool bounds = false;    ///< Rays have bounds, which are hard too.
};

/// Seconds that the parts of the work took.
struct SweepTimes {
  double oracle = 0; ///< Exact hits.
  double build = 0;  ///< Volumes.
  double kernel = 0; ///< Making kernels and uploading volumes.
  double trace = 0;  ///< Tracing, process CPU.
  std::uint64_t exactRays = 0;
};

class HardRaySweep {
public:
  HardRaySweep(std::vector<Format> formats, const HardRayScenes &scenes, const HardRayBudget &budget,
               TracingDevices &devices, HardRayReport &report, Progress progress)
      : formats_(std::move(formats)), scenes_(scenes), budget_(budget), devices_(devices), report_(report),
        progress_(std::move(progress)), quiet_{{}, progress_.stop} {}

  /// Traces rays of all classes. Errors: those of building and tracing; interrupted, with the report as far
  /// as it got.
  Expected<void> run(const SweepSize &size);
  /// Traces the rays of a corpus in every format that can hold their scene. Error also: an exact hit that is
  /// not the oracle's, or no format is large enough.
  Expected<void> runCorpus(const std::vector<CorpusRay> &corpus);

  const SweepTimes &times() const { return times_; }

private:
  using Indices = std::vector<std::size_t>;

  Expected<void> runRound(std::uint64_t round, std::uint64_t raysEach);
  Expected<void> runScene(std::size_t scene, Int3 extent, const Indices &formats, std::uint64_t round,
                          std::uint64_t raysEach);
  Expected<Oracle> makeSet(RaySet &set, std::uint64_t raysEach, std::uint64_t seed);
  Expected<void> answer(RaySet &set, const Oracle &oracle);
  Expected<void> traceSet(const RaySet &set, const Oracle &oracle, std::size_t format);
  Expected<Volume> build(const RaySet &set, std::size_t format);
  Indices formatsOf(std::size_t scene, Int3 extent, std::uint64_t round) const;
  bool isOver() const;

  std::vector<Format> formats_;
  const HardRayScenes &scenes_;
  const HardRayBudget &budget_;
  TracingDevices &devices_;
  HardRayReport &report_;
  Progress progress_;
  Progress quiet_; ///< Tells no more than whether to stop.
  SweepSize size_;
  std::vector<std::string> names_; ///< Of the scenes.
  std::map<std::size_t, Constructor> constructors_;
  Stopwatch watch_;
  SweepTimes times_;
};

} // namespace voxc::tool
