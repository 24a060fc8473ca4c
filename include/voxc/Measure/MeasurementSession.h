// Where formats of a search are built, traced in turn and checked.
#pragma once

#include "voxc/Measure/MeasuredSet.h"
#include "voxc/Measure/Record.h"
#include "voxc/Measure/Subject.h"
#include "voxc/Measure/TimeBudget.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Search/SearchScene.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace voxc::measure {

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
  std::vector<Record> records;     ///< Of each set of rays; all have failed, or none. Empty: no time left.
  std::vector<double> nanoseconds; ///< Of each set, by what the device's clock counts; empty if it failed.
};

/// What is measured beside formats, and how records name it.
struct MeasurementOptions {
  ModelPart model;
  std::string provenance; ///< Of volumes.
  std::string precision = "exact";
  Device *device = nullptr;   ///< Which must outlive the session; null: this processor.
  unsigned threads = 0;       ///< That build, and of a device that is this processor; 0: all.
  std::size_t check = 2000;   ///< Rays of each set, evenly spread, of which the oracle is asked.
  std::uint64_t maxBytes = 0; ///< Of a volume's words.
  std::string folder;         ///< That keeps volumes.
  MadeByPart madeBy;
  std::shared_ptr<WorkingMemory> memory; ///< That building may take.
};

class MeasurementSession {
public:
  /// The oracle is asked at once. The scene, which has colours, must outlive the session. Errors: of the
  /// oracle.
  static Expected<MeasurementSession> create(const SearchScene &scene, std::vector<MeasuredSet> sets,
                                             MeasurementOptions options, const Progress &progress);

  /// Builds the formats, traces them in turn and checks them. `predicted` are nanoseconds of each format and
  /// set. Error: `Interrupted`, by the caller's flag and not by the budget; what goes wrong with a format is
  /// its finding.
  Expected<std::vector<Finding>> measure(std::span<const PredictedFormat *const> formats,
                                         std::span<const std::vector<double>> predicted,
                                         const RoundOptions &roundOptions, const Progress &progress);

  /// The records that a format would have, without figures: to find what an earlier search found.
  std::vector<Record> recordsOf(const Candidate &format) const;
  /// Where its volume is kept.
  std::string volumePath(const PredictedFormat &format) const;
  /// Removes the volume of a format.
  void forget(const PredictedFormat &format) const;

private:
  struct MeasuredFormat;

  MeasurementSession(const SearchScene &scene, MeasurementOptions options)
      : scene_(&scene), options_(std::move(options)), device_(devicePart(options_.device, options_.threads)) {
  }

  Expected<Volume> build(const PredictedFormat &format, Record &record, const Progress &progress);
  Expected<void> prepare(MeasuredFormat &measured, const RoundOptions &roundOptions,
                         const Progress &progress);
  Expected<void> traceRound(MeasuredFormat &measured, bool counted, const Progress &progress) const;
  Expected<void> traceRounds(std::vector<MeasuredFormat> &allMeasured, const RoundOptions &roundOptions,
                             const Progress &progress) const;
  double quickest(const MeasuredFormat &measured) const;
  Expected<void> examine(MeasuredFormat &measured, const RoundOptions &roundOptions) const;
  Finding finish(MeasuredFormat &measured) const;
  /// What the device's clock counts.
  const Repeats &clockOf(const Times &times) const;

  const SearchScene *scene_;
  MeasurementOptions options_;
  DevicePart device_;
  std::vector<MeasuredSet> sets_; ///< Their rays are in `rays_`.
  std::vector<SampledRays> rays_;
  std::unique_ptr<Oracle> oracle_;
  double slowestCompile_ = 0; ///< Seconds that compiling took, which nothing can interrupt.
};

} // namespace voxc::measure
