// Which shares are left, and what came of them.
#include "sweep/SharedSweep.h"

#include "bench/Digest.h"

#include <filesystem>
#include <set>

namespace voxc::tool::bench {

namespace fs = std::filesystem;

Expected<SharedSweep> SharedSweep::open(const SweepAxes &axes, std::vector<Cell> cells,
                                        SharedSweepOptions options) {
  auto results = RecordWriter::open(options.folder + "/" + kResultsName);
  if (!results)
    return results.error();
  SharedSweep sweep(axes, std::move(cells), std::move(options), std::move(*results));
  // Those of this very sweep may be written to at this moment, and hold what it need not measure again.
  const std::string own = shareFileEnding(sweep.digest_, sweep.options_.shares);
  if (Expected<void> joined = joinShares(sweep.options_.folder, own, sweep.results_); !joined)
    return joined.error();
  auto kept = sweep.finished();
  if (!kept)
    return kept.error();
  sweep.kept_ = std::move(*kept);
  return sweep;
}

void SharedSweep::add(const Record &record, Records &records) const {
  for (const SweepDevice &device : axes_->devices)
    if (isMeant(device, record.device)) {
      Record asked = record;
      asked.device = device.part;
      records[cellDigest(asked)].push_back(record);
    }
}

Expected<SharedSweep::Records> SharedSweep::finished() const {
  Records records;
  const auto all = readRecords(options_.folder);
  if (!all)
    return all.error();
  for (const Record &record : *all)
    if (record.isMeasured() ? !options_.again : !options_.retry)
      add(record, records);
  if (!options_.again && !options_.retry)
    return records;
  // What this sweep's shares found counts in any case.
  for (std::uint64_t index = 0; index < options_.shares; ++index) {
    const std::string path = options_.folder + "/" + shareFileName(digest_, {index, options_.shares});
    const auto found = readRecordFile(path);
    if (!found)
      return found.error();
    for (const Record &record : *found)
      add(record, records);
  }
  return records;
}

Expected<Jobs::Missing> SharedSweep::missing() const {
  const auto known = finished();
  if (!known)
    return known.error();
  std::set<std::uint64_t> left;
  for (std::size_t i = 0; i < cells_.size(); ++i)
    if (!known->contains(cells_[i].record.cell))
      left.insert(shares_[i]);
  return Missing{{left.begin(), left.end()}};
}

std::vector<std::string> SharedSweep::command(std::size_t, const std::string &numbers) const {
  std::vector<std::string> words = options_.command;
  words.insert(words.end(), {"--share", numbers + "/" + std::to_string(options_.shares)});
  return words;
}

std::string SharedSweep::workingFolder() const {
  // Inputs, lists and the folder are named as seen from here.
  std::error_code ignored;
  return fs::current_path(ignored).string();
}

std::string SharedSweep::name() const {
  std::error_code ignored;
  Digest digest;
  digest.add(digest_)
      .add(std::to_string(options_.shares))
      .add(fs::absolute(options_.folder, ignored).string());
  return "voxc-bench-" + digest.hex();
}

Expected<std::vector<Cell>> SharedSweep::join() {
  if (Expected<void> joined = joinShares(options_.folder, "", results_); !joined)
    return joined.error();
  const auto all = readRecords(options_.folder);
  if (!all)
    return all.error();
  Records records;
  for (const Record &record : *all)
    add(record, records);
  std::vector<Cell> cells;
  for (const Cell &cell : cells_) {
    const auto found = records.find(cell.record.cell);
    if (found == records.end())
      continue;
    for (const Record &record : found->second) {
      cells.push_back(cell);
      cells.back().record = record;
      cells.back().isKept = kept_.contains(cell.record.cell);
    }
  }
  return cells;
}

} // namespace voxc::tool::bench
