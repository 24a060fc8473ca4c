// A sweep: its cells built, traced and recorded, those that an earlier run finished left alone.
#pragma once

#include "sweep/Cells.h"
#include "sweep/Group.h"
#include "sweep/VolumeCache.h"

#include "common/Command.h"
#include "voxc/Measure/RecordFile.h"
#include "voxc/Support/Progress.h"

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace voxc::tool::bench {

using namespace measure;

struct SweepOptions {
  std::string folder; ///< It is there.
  BuildMeans build;
  MeasureOptions measure;       ///< But for its progress.
  std::uint64_t groupBytes = 0; ///< Memory that the volumes and rays of a group may take.
  bool retry = false;           ///< Try failed cells again.
  bool again = false;           ///< Measure finished cells again.
  /// The file that records go to. That of a share holds what this sweep measured, which is kept in any case;
  /// without shares, those that were left are joined first.
  std::string records = kResultsName;
};

/// Refuses figures that would be taken for results: those of a folder are all its .jsonl files, which hold
/// records, and its verdicts of searches. Error: `Usage`.
Expected<void> checkFiguresNoResults(const std::string &folder, const CommonOptions &common);

/// Makes the folder of results if it is not there. Errors: `Usage`, the figures would go over what a sweep or
/// its report writes there; those of `makeOutputFolder`.
Expected<void> makeResultsFolder(const std::string &folder, const CommonOptions &common);

class Sweep {
public:
  /// Reads what earlier runs found in the folder. Errors: `Input` for a record file that is broken or in use.
  static Expected<Sweep> open(const SweepAxes &axes, std::vector<Cell> cells, SweepOptions options);

  /// Does what is pending. Cells are recorded as they are finished. Errors: `Interrupted`, `Environment`.
  Expected<void> run(const Progress &progress);

  /// All cells, with what is known of them now.
  const std::vector<Cell> &cells() const { return cells_; }

private:
  /// A volume's extent, by which its rays and oracle are told from others.
  using Extent = std::array<int, 3>;
  struct Ready {
    std::vector<BuiltCell> builtCells;
    const RaySet *rays;
    Int3 extent;
  };

  Sweep(const SweepAxes &axes, std::vector<Cell> cells, SweepOptions options, RecordWriter writer)
      : axes_(&axes), cells_(std::move(cells)), options_(std::move(options)), writer_(std::move(writer)),
        cache_((options_.folder + "/cache"), options_.build) {}
  /// What earlier runs found, and what this sweep did.
  void takeKnown(const std::vector<Record> &records, const std::vector<Record> &own);

  Expected<void> runModel(const SweepModel &model);
  Expected<std::vector<Ready>> buildModel(const SweepModel &model);
  Expected<VolumeCache::Outcome> buildFormat(const SweepModel &model, const SweepFormat &format);
  Expected<void> measureAll(const SweepModel &model, Ready &ready);
  /// Without an answer, because memory or a volume fails, there are no error figures.
  void askOracle(const Ready &ready, GroupRays &rays);
  Expected<void> measureGroup(const SweepModel &model, const Ready &ready, std::span<const BuiltCell> group,
                              const GroupRays &rays);
  std::vector<std::span<const BuiltCell>> groupsOf(const Ready &ready, std::size_t rays) const;
  Expected<void> fail(std::span<Cell *const> cells, const Failure &failure);
  Expected<void> finish(Cell &cell);
  std::vector<Cell *> pendingOf(const SweepModel &model, const SweepFormat &format);
  void advance(double steps);

  const SweepAxes *axes_;
  std::vector<Cell> cells_;
  SweepOptions options_;
  RecordWriter writer_;
  VolumeCache cache_;
  Progress progress_;
  double steps_ = 0, allSteps_ = 0;
  std::map<Extent, Oracle> oracles_; ///< Of the model that is measured.
};

} // namespace voxc::tool::bench
