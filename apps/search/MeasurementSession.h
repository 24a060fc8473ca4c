// Where formats of a search are built, traced in turn and checked.
#pragma once

#include "accuracy/Variant.h"
#include "bench/Record.h"
#include "choosing/Scene.h"
#include "common/TimeBudget.h"
#include "sweep/Cells.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Search/FormatPredictor.h"
#include "voxc/Volume/Volume.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace voxc::tool {

/// What is measured by: rays with the oracle's hits of a sample.
struct MeasuredRays {
  std::vector<Ray> rays;
  std::vector<Ray> sample; ///< Of them, evenly spread.
  std::vector<Hit> exact;  ///< The oracle's hits of the sample.
};

/// How long, and how closely, formats are looked at.
struct RoundOptions {
  unsigned rounds = 3;
  bool countsWork = false; ///< Finds steps and words a ray, for which another kernel may be compiled.
  /// True if a format that takes so many bytes, and at best so many nanoseconds a ray, need not be traced on.
  std::function<bool(double bytes, double nanoseconds)> isBeaten;
  /// Until when: what it does not allow is not begun, and what is under way stops when it is over.
  TimeBudget budget;
  unsigned leastRounds = 1; ///< A format with fewer, when the budget is over, has no finding.
};

/// What was found of a format.
struct Finding {
  std::vector<bench::Record>
      records;                     ///< For each set of rays; all have failed, or none. Empty: no time left.
  std::vector<double> nanoseconds; ///< Of each set, by what the device's clock counts; empty if it failed.
};

struct MeasurementOptions {
  unsigned threads = 0; ///< That build, and of a device that is this processor; 0: all.
  std::size_t check = 2000;
  std::uint64_t maxBytes = 0;
  std::string folder; ///< Its cache/ keeps volumes.
  bench::MadeByPart madeBy;
};

class MeasurementSession {
public:
  /// `axes` has one model with its rays, one precision and one device. The oracle is asked at once. Scene and
  /// axes must outlive the session. Errors: of the oracle.
  static Expected<MeasurementSession> create(const Scene &scene, bench::SweepAxes &axes,
                                             MeasurementOptions options,
                                             const std::shared_ptr<WorkingMemory> &memory,
                                             const Progress &progress);

  /// Builds the formats, traces them in turn and checks them. `predicted` are nanoseconds of each format and
  /// set. Error: `Interrupted`, by the caller's flag and not by the budget; what goes wrong with a format is
  /// its finding.
  Expected<std::vector<Finding>> measure(std::span<const PredictedFormat *const> formats,
                                         std::span<const std::vector<double>> predicted,
                                         const RoundOptions &roundOptions, const Progress &progress);

  /// The records that a format would have, without figures: to find what an earlier search found.
  std::vector<bench::Record> recordsOf(const PredictedFormat &format) const;
  /// Where its volume is kept.
  std::string volumePath(const PredictedFormat &format) const;
  /// Removes the volume of a format.
  void forget(const PredictedFormat &format) const;

private:
  struct MeasuredFormat;

  MeasurementSession(const Scene &scene, bench::SweepAxes &axes, MeasurementOptions options,
                     const std::shared_ptr<WorkingMemory> &memory)
      : scene_(&scene), axes_(&axes), options_(std::move(options)), memory_(memory) {}

  Expected<Volume> build(const PredictedFormat &format, bench::Record &record, const Progress &progress);
  Expected<void> prepare(MeasuredFormat &measured, const RoundOptions &roundOptions,
                         const Progress &progress);
  Expected<void> traceRound(MeasuredFormat &measured, bool counted, const Progress &progress) const;
  Expected<void> traceRounds(std::vector<MeasuredFormat> &allMeasured, const RoundOptions &roundOptions,
                             const Progress &progress) const;
  Expected<void> examine(MeasuredFormat &measured, const RoundOptions &roundOptions) const;
  Finding finish(MeasuredFormat &measured) const;

  const Scene *scene_;
  bench::SweepAxes *axes_;
  MeasurementOptions options_;
  std::shared_ptr<WorkingMemory> memory_;
  std::vector<MeasuredRays> rays_;
  std::unique_ptr<Oracle> oracle_;
  double slowestCompile_ = 0; ///< Seconds that compiling took, which nothing can interrupt.
};

} // namespace voxc::tool
