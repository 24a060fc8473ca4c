// A whole search in one call.
#include "Measure/QuestionWish.h"
#include "Support/ParallelFor.h"
#include "Support/Platform/ScratchFile.h"
#include "voxc/IR/Query.h"
#include "voxc/Measure/FormatSearch.h"
#include "voxc/Measure/Machine.h"
#include "voxc/Measure/SavedWeights.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>

namespace voxc {
namespace {

namespace fs = std::filesystem;

constexpr std::array<int, 2> kOverviewSize{480, 270};
constexpr double kMostSeconds = 1e9;
/// Several volumes of a batch lie in memory together, on a device too.
constexpr std::uint64_t kShareOfMemory = 12;

/// A folder that is there for the while.
class ScratchFolder {
public:
  ScratchFolder() : path_(platform::scratchFolder() + "/voxc-search.XXXXXX") {
    isThere_ = ::mkdtemp(path_.data()) != nullptr;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    if (isThere_)
      fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder &) = delete;
  ScratchFolder &operator=(const ScratchFolder &) = delete;

  bool isThere() const { return isThere_; }
  const std::string &path() const { return path_; }

private:
  std::string path_;
  bool isThere_ = false;
};

/// Puts a record in the place of an earlier one of the same cell.
void put(const measure::Record &record, std::vector<measure::Record> &records) {
  const auto known = std::ranges::find(records, record.cell, &measure::Record::cell);
  if (known != records.end())
    *known = record;
  else
    records.push_back(record);
}

Error tooShort(double seconds) {
  return Error::usage("the budget of " + std::to_string(std::lround(seconds)) +
                      " s ended before one format was measured; a longer one would do");
}

FormatSpeed measuredSpeed(const measure::Record &record) {
  constexpr double kMillion = 1e6;
  FormatSpeed found;
  if (record.predicted)
    found.predicted = kMillion * record.predicted->mraysPerS.value_or(0);
  if (const auto &speed = measure::speedOf(record)) {
    found.measured = kMillion * speed->median;
    found.slowest = kMillion * speed->min;
    found.fastest = kMillion * speed->max;
  }
  const measure::ErrorPart &error = record.error;
  found.checkedRays = error.rays.value_or(0);
  found.wrongRays = error.missed.value_or(0) + error.ghost.value_or(0) + error.wrong.value_or(0);
  found.maxUlp = error.maxUlpDt.value_or(0);
  return found;
}

/// A row for each format, in the order in which they were first measured.
FormatTable tableOf(const SearchScene &scene, std::vector<std::string> sets,
                    const std::vector<measure::Record> &records, const measure::SearchVerdict &verdict) {
  FormatTable table{.voxels = scene.voxels, .sets = std::move(sets)};
  std::map<std::pair<std::string, std::vector<std::string>>, std::size_t> places;
  const auto rowOf = [&](const measure::Record &record) -> FormatRow & {
    return table.rows[places.at({record.format.name, record.format.passes})];
  };
  for (const measure::Record &record : records) {
    if (places.emplace(std::pair(record.format.name, record.format.passes), table.rows.size()).second)
      table.rows.push_back({.format = record.format.name,
                            .passes = record.format.passes,
                            .bytes = record.volume.bytes.value_or(0)});
    FormatRow &row = rowOf(record);
    if (record.failure)
      row.failure = record.failure->stage + ": " + record.failure->reason;
    row.speeds.push_back(measuredSpeed(record));
  }
  for (const measure::Finalist &finalist : verdict.frontier)
    rowOf(*finalist.cells.front()).isOnFrontier = true;
  if (!verdict.frontier.empty())
    rowOf(*verdict.answer(verdict.objective).cells.front()).isChosen = true;
  return table;
}

std::vector<measure::MeasuredSet> setsOf(const SearchScene &scene, const FormatQuestion &question) {
  if (!question.rays.empty())
    return {measure::listSet("rays", question.rays)};
  std::vector<measure::MeasuredSet> sets{measure::overviewSet(scene.extent, kOverviewSize)};
  if (auto bounced = measure::bouncedSet(scene, sets.front().rays, 1))
    sets.push_back(std::move(*bounced));
  return sets;
}

measure::FormatSearchOptions optionsOf(const FormatQuestion &question, const Wish &wish, Device *device,
                                       const std::string &folder) {
  return {.wish = wish,
          .onlySeeds = !question.formats.empty(),
          .measurement = {.precision = question.precision,
                          .device = device,
                          .threads = threadsOrAll(question.threads),
                          .maxBytes = wish.maxBytes,
                          .folder = folder,
                          .madeBy = measure::madeBy(""),
                          .memory = question.memory}};
}

Expected<FormatTable> search(const SearchScene &scene, std::vector<Candidate> seeds,
                             const FormatQuestion &question, const measure::FormatSearchOptions &options,
                             const measure::TimeBudget &budget, const Progress &progress) {
  std::vector<measure::MeasuredSet> sets = setsOf(scene, question);
  std::vector<std::string> names;
  names.reserve(sets.size());
  for (const measure::MeasuredSet &set : sets)
    names.push_back(set.part.name);
  const Error none = explainNone(seeds, scene);
  measure::FormatSearch search(scene, std::move(sets), options);
  Explored explored = search.explore(std::move(seeds), budget, progress);
  VOXC_TRY(progress.check());
  if (explored.formats.empty())
    return budget.isOver() ? tooShort(question.seconds) : none;
  std::vector<measure::Record> records;
  const auto keep = [&](const measure::Record &record) {
    put(record, records);
    return Expected<void>();
  };
  const Expected<void> measured = search.measure(std::move(explored), {}, keep, budget, progress);
  if (!measured && (progress.stopped() || measured.error().kind != ErrorKind::Interrupted))
    return measured.error();
  if (!search.loop() || search.loop()->findings().empty())
    return tooShort(question.seconds);
  // The answer stands without what the next search would begin with.
  static_cast<void>(measure::keepSpeedModel(
      measure::devicePart(options.measurement.device, options.measurement.threads).name,
      search.acquisition()->model()));
  return tableOf(scene, std::move(names), records, search.verdict(records));
}

} // namespace

Expected<FormatTable> searchFormats(const SourceOpener &open, const FormatQuestion &question,
                                    const Progress &progress) {
  if (!(question.seconds > 0 && question.seconds < kMostSeconds))
    return Error::usage("a search takes seconds, more than 0 and less than 1e9");
  const measure::TimeBudget budget(question.seconds);
  auto wish = VOXC_TRY(measure::wishOf(question));
  const auto precisions = precisionNames();
  if (std::ranges::find(precisions, question.precision) == precisions.end())
    return Error::usage("'" + question.precision + "' is no precision; those are exact and fast");
  if (question.maxBytes == 0)
    wish.maxBytes = std::min(wish.maxBytes, measure::machineMemory() / kShareOfMemory);
  measure::Devices devices;
  const auto device = VOXC_TRY(devices.open(question.device));
  FormatQuestion asked = question;
  if (!asked.memory)
    asked.memory = WorkingMemory::createDefault();
  const auto scene = VOXC_TRY(readSearchScene(asked.name, open, asked.memory, progress));
  if (!scene.colours)
    return Error::environment("the scene with its colours takes more than the memory that may be used; more "
                              "memory or a lower resolution would do");
  auto seeds = VOXC_TRY(candidatesOf(asked.formats, scene));
  const ScratchFolder folder;
  if (!folder.isThere())
    return Error::environment("cannot make a folder such as '" + folder.path() + "'");
  return search(scene, std::move(seeds), asked, optionsOf(asked, wish, device, folder.path()), budget,
                progress);
}

} // namespace voxc
