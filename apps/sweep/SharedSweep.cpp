// Which shares are left, and what came of them.
#include "sweep/SharedSweep.h"

#include "options/Outputs.h"
#include "voxc/Measure/Digest.h"

#include <filesystem>
#include <set>

namespace voxc::tool::bench {

namespace fs = std::filesystem;

Expected<SharedSweep> SharedSweep::open(SharedCells cells, SharedSweepOptions options) {
  auto results = VOXC_TRY(RecordWriter::open(options.folder + "/" + kResultsName));
  SharedSweep sweep(std::move(cells), std::move(options), std::move(results));
  // Those of this very sweep may be written to at this moment, and hold what it need not measure again.
  const std::string own = shareFileEnding(sweep.cells_.digest, sweep.cells_.count);
  VOXC_TRY(joinShares(sweep.options_.folder, own, sweep.results_));
  sweep.kept_ = VOXC_TRY(sweep.finished());
  return sweep;
}

void SharedSweep::add(const Record &record, Records &records) const {
  if (cells_.named.empty())
    records[record.cell].push_back(record);
  for (const SweepDevice &device : cells_.named)
    if (isMeant(device, record.device)) {
      Record asked = record;
      asked.device = device.part;
      records[cellDigest(asked)].push_back(record);
    }
}

Expected<SharedSweep::Records> SharedSweep::finished() const {
  Records records;
  const auto all = VOXC_TRY(readRecords(options_.folder));
  for (const Record &record : all)
    if (record.isMeasured() ? !options_.again : !options_.retry)
      add(record, records);
  if (!options_.again && !options_.retry)
    return records;
  // What this sweep's shares found counts in any case.
  for (std::uint64_t index = 0; index < cells_.count; ++index) {
    const std::string path = options_.folder + "/" + shareFileName(cells_.digest, {index, cells_.count});
    const auto found = VOXC_TRY(readRecordFile(path));
    for (const Record &record : found)
      add(record, records);
  }
  return records;
}

Expected<Jobs::Missing> SharedSweep::missing() const {
  const auto known = VOXC_TRY(finished());
  std::set<std::uint64_t> left;
  for (std::size_t i = 0; i < cells_.cells.size(); ++i)
    if (!known.contains(cells_.cells[i]))
      left.insert(cells_.shares[i]);
  return Missing{{left.begin(), left.end()}};
}

std::vector<std::string> SharedSweep::command(std::size_t, const std::string &numbers) const {
  std::vector<std::string> words = options_.command;
  words.insert(words.end(), {"--share", numbers + "/" + std::to_string(cells_.count)});
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
  digest.add(cells_.digest)
      .add(std::to_string(cells_.count))
      .add(fs::canonical(options_.folder, ignored).string());
  return "voxc-bench-" + digest.hex();
}

Expected<std::vector<SharedSweep::Found>> SharedSweep::join() {
  VOXC_TRY(joinShares(options_.folder, "", results_));
  const auto all = VOXC_TRY(readRecords(options_.folder));
  Records records;
  for (const Record &record : all)
    add(record, records);
  std::vector<Found> found;
  found.reserve(cells_.cells.size());
  for (const std::string &cell : cells_.cells)
    found.push_back({records[cell], kept_.contains(cell)});
  return found;
}

Expected<std::vector<SharedSweep::Found>> measureInShares(SharedCells cells, SharedSweepOptions options,
                                                          const ShareOptions &how, unsigned threads,
                                                          const JobWatch &watch, Json &figures) {
  auto sweep = VOXC_TRY(SharedSweep::open(std::move(cells), std::move(options)));
  VOXC_TRY(makeOutputFolder(sweep.folder()));
  VOXC_TRY(how.jobs().run(sweep, threads, watch, figures));
  return how.jobs().waits() ? sweep.join() : std::vector<SharedSweep::Found>();
}

} // namespace voxc::tool::bench
