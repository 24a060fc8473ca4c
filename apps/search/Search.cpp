// voxc search: the formats that are best for an input, these rays and this device, found by measuring those
// that promise most.
#include "search/SearchCells.h"
#include "search/SearchRays.h"
#include "search/SearchReport.h"

#include "bench/Machine.h"
#include "choosing/SavedWeights.h"
#include "common/Files.h"
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "common/TimeBudget.h"
#include "jobs/PythonProgram.h"
#include "options/Outputs.h"
#include "program/Applications.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace voxc::tool {

namespace {

/// Volumes of more than so many times the bytes of the smallest are not looked for.
constexpr double kSizesOfUse = 64;

/// Of the time that is left when the input was read, that rating formats may take, and simulating rays again,
constexpr double kExploringShare = 0.25;
/// and both together at most, whatever the formats are that it begins with: less where few seconds are left.
constexpr double kMostExploring = 0.6, kLeastExploring = 0.25, kSecondsOfMeasuring = 12;

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
  Explored predict(const Scene &scene, const std::vector<RaySet> &rays, const SpeedModel &model,
                   std::vector<Candidate> seeds) const;
  Expected<void> search(Scene &scene, Json &figures);
  Expected<void> measureElsewhere(const Explored &explored, const std::vector<Candidate> &seeds,
                                  bench::SweepAxes &axes, Json &figures);
  Expected<void> measure(Scene &scene, bench::SweepAxes &axes, Explored explored, const SpeedModel &model,
                         Json &figures);
  /// What the verdict is told of.
  struct Told {
    const bench::SweepAxes &axes;
    std::size_t rated; ///< Formats.
    const Acquisition &acquisition;
    const SearchLoop &loop;
  };
  Expected<void> tell(const Told &told, Json &figures);
  void makePage() const;
  void addKnown(const Scene &scene, std::vector<Candidate> &seeds) const;

  SearchOptions options_;
  Progress progress_;
  ProgressBar *bar_ = nullptr;
  Stopwatch watch_;
  TimeBudget budget_; ///< Until what was found has to be told.
  std::shared_ptr<WorkingMemory> memory_;
  std::vector<bench::Record> known_; ///< What earlier searches found.
  std::string recordsName_ = bench::kResultsName;
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

Explored SearchCommand::predict(const Scene &scene, const std::vector<RaySet> &rays, const SpeedModel &model,
                                std::vector<Candidate> seeds) const {
  FormatPredictor predictor(scene.priced());
  ExploreOptions options = options_.explore;
  options.seconds = kExploringShare * std::max(budget_.left(), 0.0);
  Progress progress = bounded();
  if (!options_.formatList.empty()) {
    // They and no others: nothing is rewritten, nothing left out.
    options.mostFormats = seeds.size();
    options.kept = std::numeric_limits<double>::infinity();
  } else {
    const double left = std::max(budget_.left(), 0.0);
    const double most =
        std::min(kMostExploring * left, std::max(kLeastExploring * left, left - kSecondsOfMeasuring));
    progress = budget_.endingAfter(budget_.spent() + most).within(progress_);
  }
  if (options_.formatList.empty() && options_.maxLevels > 0) {
    options.maxLevels = options_.maxLevels;
    std::erase_if(seeds,
                  [&](const Candidate &seed) { return seed.format.levels.size() > options.maxLevels; });
  }
  return explore(predictor, std::move(seeds), scene.traits, rays, model, options_.wish, options, progress);
}

Expected<void> SearchCommand::tell(const Told &told, Json &figures) {
  const auto cells = bench::readRecords(options_.folder);
  if (!cells)
    return cells.error();
  const bench::SearchVerdict verdict = verdictOf(*cells, told.loop, options_.objective());
  const SearchResult result{.input = options_.input,
                            .arguments = options_.inputArguments,
                            .device = told.axes.devices.front().part.name,
                            .rays = namesOf(told.axes.models.front().rays),
                            .rated = told.rated,
                            .kept = told.acquisition.formats().size(),
                            .seconds = watch_.seconds(),
                            .acquisition = told.acquisition,
                            .loop = told.loop,
                            .verdict = verdict};
  bar_->clear();
  addSearchFigures(figures, result);
  std::fputs(searchReport(result).c_str(), stdout);
  std::fflush(stdout);
  if (Expected<void> written = bench::writeVerdict(options_.folder, verdict); !written)
    return written;
  if (!progress_.stopped())
    makePage();
  return writeStatistics(options_.common.stats, figures);
}

/// The answer stands without a page, which needs more than voxc.
void SearchCommand::makePage() const {
  const auto made = runPythonProgram("bench-report.py", {"--", options_.folder}, progress_.silent());
  if (options_.common.quiet)
    return;
  if (made)
    printNote("wrote report.html, report.csv and " + std::string(bench::kResultsName) + " in " +
              options_.folder);
  else
    printNote("wrote " + std::string(bench::kResultsName) + " in " + options_.folder +
              ", but no page: " + made.error().message);
}

Expected<void> SearchCommand::measure(Scene &scene, bench::SweepAxes &axes, Explored explored,
                                      const SpeedModel &model, Json &figures) {
  const auto smallest = std::ranges::min_element(explored.formats, {}, &PredictedFormat::bytes);
  const double mostBytes = kSizesOfUse * static_cast<double>(smallest->bytes());
  Acquisition acquisition(std::move(explored.formats), model,
                          {.mostBytes = mostBytes, .leastSpeed = options_.leastSpeed});
  auto writer = bench::RecordWriter::open(options_.folder + "/" + recordsName_);
  if (!writer)
    return writer.error();
  if (!options_.shares.share())
    if (Expected<void> joined = bench::joinShares(options_.folder, "", *writer); !joined)
      return joined;
  auto session = MeasurementSession::create(scene, axes,
                                            {.threads = threadsOf(options_.building),
                                             .check = options_.check,
                                             .maxBytes = options_.wish.maxBytes,
                                             .folder = options_.folder,
                                             .madeBy = bench::madeBy(options_.commandText())},
                                            memory_, bounded());
  if (!session)
    return isOutOfTime(session.error()) ? tooShort("exact hits were found") : session.error();
  // What others took for their shares is not of this budget.
  SearchLoopOptions loopOptions{.budget =
                                    options_.shares.areElsewhere() ? TimeBudget(options_.budget) : budget_};
  if (options_.all)
    loopOptions.leastGain = -1;
  if (options_.shares.share())
    loopOptions.lastRounds = 0;
  SearchLoop loop(acquisition, *session, *writer, loopOptions);
  loop.takeKnown(known_);
  Expected<void> measured = loop.run(progress_);
  const bool isInterrupted = !measured && measured.error().kind == ErrorKind::Interrupted;
  if ((!measured && (!isInterrupted || loop.findings().empty())) || options_.shares.share())
    return measured;
  if (measured && loop.findings().empty())
    return tooShort("the first format was built");
  Expected<void> told = tell({axes, explored.rated, acquisition, loop}, figures);
  // The answer stands without what the next search would begin with.
  if (Expected<void> remembered = keepSpeedModel(axes.devices.front().part.name, acquisition.model());
      !remembered && !options_.common.quiet)
    printNote("what was learned of the device is not kept: " + remembered.error().message);
  return told ? measured : told;
}

/// Formats that an earlier search came to are rated whatever the budget is, so that none is forgotten.
void SearchCommand::addKnown(const Scene &scene, std::vector<Candidate> &seeds) const {
  for (const bench::Record &record : known_)
    if (auto candidate = makeCandidate(record.format.name, scene.traits, choicesOf(record.format.passes)))
      if (candidate->passes == record.format.passes)
        seeds.push_back(std::move(*candidate));
}

/// Has the formats measured in shares. What is known then is as if it had been measured here.
Expected<void> SearchCommand::measureElsewhere(const Explored &explored, const std::vector<Candidate> &seeds,
                                               bench::SweepAxes &axes, Json &figures) {
  constexpr std::size_t kFormatsOfShare = 16;
  const std::uint64_t count = options_.shares.count((seeds.size() + kFormatsOfShare - 1) / kFormatsOfShare);
  const auto found = bench::measureInShares(
      sharedCells(explored.formats, seeds, count, axes), {options_.folder, options_.shares.command("search")},
      options_.shares, options_.building.threads, {progress_, options_.common.quiet}, figures);
  if (!found)
    return found.error();
  auto known = bench::readRecords(options_.folder);
  if (!known)
    return known.error();
  known_ = std::move(*known);
  return {};
}

Expected<void> SearchCommand::search(Scene &scene, Json &figures) {
  if (!scene.colours)
    return Error::environment("the scene with its colours takes more than the memory that may be used; "
                              "--memory allows more, and a lower --resolution takes less");
  auto axes = makeSearchAxes(options_, scene);
  if (!axes)
    return axes.error();
  auto seeds = readCandidates(options_.formatList, scene);
  if (!seeds)
    return seeds.error();
  auto known = bench::readRecords(options_.folder);
  if (!known)
    return known.error();
  known_ = std::move(*known);
  if (options_.formatList.empty())
    addKnown(scene, *seeds);
  noteOtherSizes(*seeds, scene, options_.common);
  if (const auto share = options_.shares.share()) {
    recordsName_ = bench::shareFileName(searchDigest(*seeds, *axes), *share);
    keepShare(*seeds, *share);
  }
  const SpeedModel model = knownSpeedsOf(axes->devices.front().part.name).model;
  const Stopwatch exploring;
  Explored explored = predict(scene, simulatedRays(scene, *axes), model, *seeds);
  figures["explore_seconds"] = exploring.seconds();
  if (progress_.stopped())
    return Error::interrupted();
  if (explored.formats.empty())
    return budget_.isOver() ? tooShort("speeds were predicted") : explainNone(*seeds, scene);
  if (options_.shares.areElsewhere()) {
    if (Expected<void> measured = measureElsewhere(explored, *seeds, *axes, figures); !measured)
      return measured;
    if (!options_.shares.jobs().waits())
      return writeStatistics(options_.common.stats, figures);
  }
  return measure(scene, *axes, std::move(explored), model, figures);
}

Expected<void> SearchCommand::run() {
  watch_ = {};
  if (Expected<void> usable = options_.read(); !usable)
    return usable;
  budget_ = TimeBudget(options_.budget - std::min(kEndSeconds, kEndShare * options_.budget));
  if (Expected<void> made = makeOutputFolder(options_.folder + "/cache"); !made)
    return made;
  bench::disableShaderCaches();
  ProgressBar bar(options_.common.quiet);
  bar_ = &bar;
  progress_ = bar.progress();
  memory_ = makeWorkingMemory(options_.building);
  Json figures;
  Expected<Scene> scene =
      readScene(options_.input, options_.inputArguments, memory_, options_.common, bounded(), figures);
  if (!scene)
    return isOutOfTime(scene.error()) ? tooShort("the input was read") : scene.error();
  return search(*scene, figures);
}

} // namespace

std::unique_ptr<Subcommand> makeSearchCommand() { return std::make_unique<SearchCommand>(); }

} // namespace voxc::tool
