// A sweep whose shares are measured by other processes, here or by Slurm.
#pragma once

#include "jobs/Jobs.h"
#include "sweep/ShareOptions.h"

#include <map>
#include <string>
#include <vector>

namespace voxc::tool::bench {

struct SharedCells {
  std::vector<std::string> cells;    ///< What each is known by, as records have it.
  std::vector<std::uint64_t> shares; ///< In which each is.
  std::uint64_t count = 1;           ///< Of shares.
  /// What cells were made with that know devices by name: a record counts for one by any device that is
  /// meant.
  std::vector<SweepDevice> named;
  std::string digest; ///< Of the sweep.
};

struct SharedSweepOptions {
  std::string folder;                ///< Of the records. It is there.
  std::vector<std::string> command;  ///< Words that measure a share, but for --share.
  bool retry = false, again = false; ///< As `SweepOptions`.
};

class SharedSweep final : public Jobs {
public:
  /// Takes in the share files that other sweeps left. Errors: `Input` for a record file that is broken or in
  /// use, `Environment`.
  static Expected<SharedSweep> open(SharedCells cells, SharedSweepOptions options);

  /// What there is of a cell.
  struct Found {
    std::vector<Record> records; ///< One by each device.
    bool isKept = false;         ///< It was there when this was opened.
  };
  /// Joins the records of the shares to the others, and returns what is known of each cell. Errors: the same.
  Expected<std::vector<Found>> join();

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

  SharedSweep(SharedCells cells, SharedSweepOptions options, RecordWriter results)
      : cells_(std::move(cells)), options_(std::move(options)), results_(std::move(results)) {}
  /// Adds a record to the cells that it is of.
  void add(const Record &record, Records &records) const;
  /// What there is of the cells and counts.
  Expected<Records> finished() const;

  SharedCells cells_;
  SharedSweepOptions options_;
  RecordWriter results_;
  Records kept_; ///< What was finished when this was opened.
};

/// Hands the shares of a sweep over and waits for them, as the options say; then joins their records. Figures
/// of the jobs are added. Nothing is found yet if the options say not to wait. Errors: those of `JobOptions`
/// and `SharedSweep`.
Expected<std::vector<SharedSweep::Found>> measureInShares(SharedCells cells, SharedSweepOptions options,
                                                          const ShareOptions &how, unsigned threads,
                                                          const JobWatch &watch, Json &figures);

} // namespace voxc::tool::bench
