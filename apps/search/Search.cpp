// voxc search: the formats that are best for an input, these rays and this device, found by measuring those
// that promise most.
#include "search/SearchCells.h"
#include "search/SearchRays.h"
#include "search/SearchReport.h"
#include "sweep/Sweep.h"

#include "common/Files.h"
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "jobs/PythonProgram.h"
#include "options/Figures.h"
#include "options/Outputs.h"
#include "program/Applications.h"
#include "voxc/Measure/FormatSearch.h"
#include "voxc/Measure/Machine.h"
#include "voxc/Measure/RecordFile.h"
#include "voxc/Measure/SavedWeights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace voxc::tool {

namespace {

/// Seconds that the page and the end of the process take, and the share of the budget that they are at most.
constexpr double kEndSeconds = 1.5, kEndShare = 0.05;

std::vector<std::string> namesOf(const std::vector<bench::RaySet> &sets) {
  std::vector<std::string> names;
  names.reserve(sets.size());
  for (const bench::RaySet &set : sets)
    names.push_back(set.part.name);
  return names;
}

class SearchCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override { options_.declare(command); }
  Expected<void> run() override;

private:
  /// Progress that ends with the budget: not of what others are waited for.
  Progress bounded() const { return options_.shares.areElsewhere() ? progress_ : budget_.within(progress_); }
  /// Whether work was ended by the budget, and not by the user.
  bool isOutOfTime(const Error &error) const {
    return error.kind == ErrorKind::Interrupted && !progress_.stopped();
  }
  Error tooShort(const std::string &meanwhile) const;
  Error tooSlow(const Acquisition &rated) const;
  Expected<void> search(Scene &scene, Json &figures);
  Expected<void> measureElsewhere(const Explored &explored, const std::vector<Candidate> &seeds,
                                  bench::SweepAxes &axes, Json &figures);
  measure::FormatSearchOptions searchOptions(const Scene &scene, const bench::SweepAxes &axes,
                                             Device *device) const;
  Expected<void> measure(const bench::SweepAxes &axes, measure::FormatSearch &search, Explored explored,
                         Json &figures);
  /// What the verdict is told of.
  struct Told {
    const bench::SweepAxes &axes;
    std::size_t rated; ///< Formats.
    const measure::FormatSearch &search;
  };
  Expected<void> tell(const Told &told, Json &figures);
  void makePage() const;
  void addKnown(const Scene &scene, std::vector<Candidate> &seeds) const;

  SearchOptions options_;
  Progress progress_;
  ProgressBar *bar_ = nullptr;
  Stopwatch watch_;
  measure::TimeBudget budget_; ///< Until what was found has to be told.
  std::shared_ptr<WorkingMemory> memory_;
  std::vector<measure::Record> known_; ///< What earlier searches found.
  std::string recordsName_ = measure::kResultsName;
};

/// The budget ended before anything was measured.
Error SearchCommand::tooShort(const std::string &meanwhile) const {
  constexpr double kRoundBudgets[] = {1,  2,   5,   10,  15,  20,   30,   45,   60,
                                      90, 120, 180, 300, 600, 1200, 1800, 3600, 7200};
  // What comes after takes about as long again, and the machine may be busy.
  constexpr double kTimes = 3;
  const auto enough =
      std::ranges::lower_bound(kRoundBudgets, kTimes * std::max(watch_.seconds(), options_.budget));
  const double seconds = enough == std::end(kRoundBudgets) ? kTimes * options_.budget : *enough;
  return Error::usage("the budget ended while " + meanwhile + ", before one format was measured; about " +
                      std::to_string(std::lround(seconds)) + "s is the least for this input (--budget)");
}

/// Nothing was measured, as nothing promised to be of use.
Error SearchCommand::tooSlow(const Acquisition &rated) const {
  double fastest = 0;
  for (std::size_t i = 0; i < rated.formats().size(); ++i)
    fastest = std::max(fastest, 1000 / rated.expect(i).nanoseconds);
  std::array<char, 160> text;
  std::snprintf(text.data(), text.size(),
                "no format comes near the %g M/s that --min-speed asks for; of the %zu that were rated, the "
                "fastest is predicted to have %.2f M/s",
                options_.leastSpeed, rated.formats().size(), fastest);
  return Error::input(text.data());
}

Expected<void> SearchCommand::tell(const Told &told, Json &figures) {
  const auto cells = VOXC_TRY(measure::readRecords(options_.folder));
  const measure::SearchVerdict verdict = told.search.verdict(cells);
  const SearchResult result{.input = options_.input,
                            .arguments = options_.inputArguments,
                            .device = told.axes.devices.front().part.name,
                            .rays = namesOf(told.axes.models.front().rays),
                            .rated = told.rated,
                            .kept = told.search.acquisition()->formats().size(),
                            .seconds = watch_.seconds(),
                            .isInterrupted = progress_.stopped(),
                            .leastSpeed = options_.leastSpeed,
                            .acquisition = *told.search.acquisition(),
                            .loop = *told.search.loop(),
                            .verdict = verdict};
  bar_->clear();
  addSearchFigures(figures, result);
  if (tellsOnStdout(options_.common))
    std::fputs(searchReport(result).c_str(), stdout);
  std::fflush(stdout);
  VOXC_TRY(measure::writeVerdict(options_.folder, verdict));
  if (!progress_.stopped())
    makePage();
  VOXC_TRY(writeStatistics(options_.common.stats, figures));
  return verdict.frontier.empty() ? Error::input(whyNoAnswer(result)) : Expected<void>();
}

/// The answer stands without a page, which needs more than voxc.
void SearchCommand::makePage() const {
  const auto made = runPythonProgram("bench-report.py", {"--", options_.folder}, progress_.silent());
  if (options_.common.quiet)
    return;
  if (made)
    printNote("wrote report.html, report.csv and " + std::string(measure::kResultsName) + " in " +
              options_.folder);
  else
    printNote("wrote " + std::string(measure::kResultsName) + " in " + options_.folder +
              ", but no page: " + made.error().message);
}

measure::FormatSearchOptions SearchCommand::searchOptions(const Scene &scene, const bench::SweepAxes &axes,
                                                          Device *device) const {
  const bench::Model &model = axes.models.front().model;
  return {.wish = options_.wish,
          .leastSpeed = options_.leastSpeed,
          .onlySeeds = !options_.formatList.empty(),
          .maxLevels = options_.maxLevels,
          .measuresAll = options_.all,
          .measuresAgain = !options_.shares.share(),
          .explore = options_.explore,
          .measurement = {.model = bench::partOf(model),
                          .provenance = scene.provenance,
                          .precision = options_.precision,
                          .device = device,
                          .threads = threadsOf(options_.building),
                          .check = options_.check,
                          .maxBytes = options_.wish.maxBytes,
                          .folder = options_.folder + "/cache",
                          .madeBy = measure::madeBy(options_.commandText()),
                          .memory = memory_}};
}

Expected<void> SearchCommand::measure(const bench::SweepAxes &axes, measure::FormatSearch &search,
                                      Explored explored, Json &figures) {
  auto writer = VOXC_TRY(measure::RecordWriter::open(options_.folder + "/" + recordsName_));
  if (!options_.shares.share())
    VOXC_TRY(bench::joinShares(options_.folder, "", writer));
  const std::size_t rated = explored.rated;
  const auto keep = [&](const measure::Record &record) { return writer.append(record); };
  // What others took for their shares is not of this budget.
  const measure::TimeBudget budget =
      options_.shares.areElsewhere() ? measure::TimeBudget(options_.budget) : budget_;
  Expected<void> measured = search.measure(std::move(explored), known_, keep, budget, progress_);
  if (!search.loop())
    return isOutOfTime(measured.error()) ? tooShort("exact hits were found") : measured.error();
  const bool isInterrupted = !measured && measured.error().kind == ErrorKind::Interrupted;
  const bool hasFound = !search.loop()->findings().empty();
  if ((!measured && (!isInterrupted || !hasFound)) || options_.shares.share())
    return measured;
  if (measured && !hasFound)
    return options_.leastSpeed > 0 && search.loop()->isComplete() ? tooSlow(*search.acquisition())
                                                                  : tooShort("the first format was built");
  Expected<void> told = tell({axes, rated, search}, figures);
  // The answer stands without what the next search would begin with.
  const std::string &device = axes.devices.front().part.name;
  if (Expected<void> remembered = measure::keepSpeedModel(device, search.acquisition()->model());
      !remembered && !options_.common.quiet)
    printNote("what was learned of the device is not kept: " + remembered.error().message);
  return told ? measured : told;
}

/// Formats that an earlier search came to are rated whatever the budget is, so that none is forgotten.
void SearchCommand::addKnown(const Scene &scene, std::vector<Candidate> &seeds) const {
  for (const measure::Record &record : known_)
    if (auto candidate = makeCandidate(record.format.name, scene.traits, choicesOf(record.format.passes)))
      if (candidate->passes == record.format.passes)
        seeds.push_back(std::move(*candidate));
}

/// Has the formats measured in shares. What is known then is as if it had been measured here.
Expected<void> SearchCommand::measureElsewhere(const Explored &explored, const std::vector<Candidate> &seeds,
                                               bench::SweepAxes &axes, Json &figures) {
  constexpr std::size_t kFormatsOfShare = 16;
  const std::uint64_t count = options_.shares.count((seeds.size() + kFormatsOfShare - 1) / kFormatsOfShare);
  VOXC_TRY(bench::measureInShares(sharedCells(explored.formats, seeds, count, axes),
                                  {options_.folder, options_.shares.command("search")}, options_.shares,
                                  options_.building.threads, {progress_, options_.common.quiet}, figures));
  known_ = VOXC_TRY(measure::readRecords(options_.folder));
  return {};
}

Expected<void> SearchCommand::search(Scene &scene, Json &figures) {
  if (!scene.colours)
    return Error::environment("the scene with its colours takes more than the memory that may be used; "
                              "--memory allows more, and a lower --resolution takes less");
  auto axes = VOXC_TRY(makeSearchAxes(options_, scene));
  auto seeds = VOXC_TRY(readCandidates(options_.formatList, scene));
  known_ = VOXC_TRY(measure::readRecords(options_.folder));
  if (options_.formatList.empty())
    addKnown(scene, seeds);
  noteOtherSizes(seeds, scene, options_.common);
  if (const auto share = options_.shares.share()) {
    recordsName_ = bench::shareFileName(searchDigest(seeds, axes), *share);
    keepShare(seeds, *share);
  }
  measure::Devices devices;
  const auto device = VOXC_TRY(devices.open(options_.device));
  measure::FormatSearch search(scene, measuredSets(scene, axes), searchOptions(scene, axes, device));
  const Stopwatch exploring;
  // Others are waited for, however long they take.
  Explored explored =
      search.explore(seeds, options_.shares.areElsewhere() ? measure::TimeBudget() : budget_, progress_);
  figures["explore_seconds"] = exploring.seconds();
  VOXC_TRY(progress_.check());
  if (explored.formats.empty())
    return budget_.isOver() ? tooShort("speeds were predicted") : explainNone(seeds, scene);
  if (options_.shares.areElsewhere()) {
    VOXC_TRY(measureElsewhere(explored, seeds, axes, figures));
    if (!options_.shares.jobs().waits())
      return writeStatistics(options_.common.stats, figures);
  }
  return measure(axes, search, std::move(explored), figures);
}

Expected<void> SearchCommand::run() {
  watch_ = {};
  VOXC_TRY(options_.read());
  budget_ = measure::TimeBudget(options_.budget - std::min(kEndSeconds, kEndShare * options_.budget));
  VOXC_TRY(bench::makeResultsFolder(options_.folder, options_.common));
  VOXC_TRY(makeOutputFolder(options_.folder + "/cache"));
  measure::disableShaderCaches();
  ProgressBar bar(options_.common.quiet);
  bar_ = &bar;
  progress_ = bar.progress();
  memory_ = makeWorkingMemory(options_.building);
  Json figures;
  Expected<Scene> scene = readScene(options_.input, sceneOptions(options_.inputArguments, memory_, bounded()),
                                    options_.common, figures);
  if (!scene)
    return isOutOfTime(scene.error()) ? tooShort("the input was read") : scene.error();
  return search(*scene, figures);
}

} // namespace

std::unique_ptr<Subcommand> makeSearchCommand() { return std::make_unique<SearchCommand>(); }

} // namespace voxc::tool
