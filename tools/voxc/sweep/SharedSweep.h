// A sweep whose shares are measured by other processes, here or by Slurm.
#pragma once

#include "jobs/Jobs.h"
#include "sweep/Shares.h"

#include <map>
#include <string>
#include <vector>

namespace voxc::tool::bench {

struct SharedSweepOptions {
  std::string folder;                ///< It is there.
  std::uint64_t shares = 1;          ///< How many.
  std::vector<std::string> command;  ///< Words that measure one, but for --share.
  bool retry = false, again = false; ///< As `SweepOptions`.
};

/// The cells have devices of `namedDevices`: where they are measured others are there than here. A cell is
/// measured if there is a record of it by any device that its own stands for.
class SharedSweep final : public Jobs {
public:
  /// Takes in the share files that earlier sweeps left. The axes must outlive it. Errors: `Input` for a
  /// record file that is broken or in use, `Environment`.
  static Expected<SharedSweep> open(const SweepAxes &axes, std::vector<Cell> cells,
                                    SharedSweepOptions options);

  /// Joins the records of the shares to the others, and returns all cells with what is known of them: one for
  /// each device that measured it. Errors: the same.
  Expected<std::vector<Cell>> join();

  std::size_t levels() const override { return 1; }
  Expected<Missing> missing() const override;
  std::vector<std::string> command(std::size_t level, const std::string &numbers) const override;
  std::uint64_t costOf(std::size_t, std::uint64_t) const override { return 1; }
  std::string name() const override;
  std::string folder() const override { return options_.folder + "/jobs"; }
  std::string workingFolder() const override;
  std::string itemName(std::size_t) const override { return "a share"; }
  std::string allName() const override { return "the sweep's shares"; }

private:
  using Records = std::map<std::string, std::vector<Record>>; ///< By the cells that they are of.

  SharedSweep(const SweepAxes &axes, std::vector<Cell> cells, SharedSweepOptions options,
              RecordWriter results)
      : axes_(&axes), cells_(std::move(cells)), shares_(shareOfEach(cells_, options.shares)),
        options_(std::move(options)), digest_(sweepDigest(axes)), results_(std::move(results)) {}
  /// Adds a record to the cells that it is of.
  void add(const Record &record, Records &records) const;
  /// What there is of the cells and counts.
  Expected<Records> finished() const;

  const SweepAxes *axes_;
  std::vector<Cell> cells_;
  std::vector<std::uint64_t> shares_; ///< Of each cell.
  SharedSweepOptions options_;
  std::string digest_;
  RecordWriter results_;
  Records kept_; ///< What was finished when this was opened.
};

} // namespace voxc::tool::bench
