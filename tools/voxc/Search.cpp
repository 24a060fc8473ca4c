// voxc search: the formats that are best for an input, these rays and this device, found by measuring those
// that promise most.
#include "BuildArguments.h"
#include "Outputs.h"
#include "Subcommand.h"

#include "common/Files.h"
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "report/Cells.h"
#include "report/Report.h"
#include "search/BuildCommand.h"
#include "search/KeptWeights.h"
#include "search/SearchReport.h"
#include "sweep/Machine.h"
#include "voxc/Search/Explore.h"
#include "voxc/Search/SampleRays.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>

namespace voxc::tool {

namespace {

const std::map<std::string, Wish::Objective> kObjectives = {{"balanced", Wish::Objective::Balanced},
                                                            {"fastest", Wish::Objective::Fastest},
                                                            {"smallest", Wish::Objective::Smallest}};

/// Volumes of more than so many times the bytes of the smallest are not looked for.
constexpr double kSizesOfUse = 64;

class SearchCommand final : public Subcommand {
public:
  void declare(CLI::App &app) override;
  Expected<void> run() override;

private:
  Expected<void> checkUsage();
  Expected<bench::SweepAxes> readAxes(const Scene &scene) const;
  Expected<std::vector<bench::RaySet>> measuredRays(const Scene &scene) const;
  std::vector<RaySet> replayedRays(const Scene &scene, const std::vector<bench::RaySet> &measured) const;
  Explored foretell(const Scene &scene, const std::vector<RaySet> &rays, const SpeedModel &model,
                    std::vector<Candidate> seeds) const;
  Expected<void> search(Scene &scene, Json &figures);
  Expected<void> measure(Scene &scene, bench::SweepAxes &axes, Explored explored, const SpeedModel &model,
                         Json &figures);
  Expected<void> tell(const SearchResult &result, Json &figures);
  std::string commandText() const;

  std::string input_, folder_;
  InputArguments inputArguments_;
  double budget_ = 180;
  std::string budgetText_ = "180s";
  std::string device_, precision_ = "exact", objective_ = "balanced", formatsPath_;
  double leastSpeed_ = 0;
  bench::RayArguments rays_;
  ExploreOptions explore_;
  std::size_t check_ = 2000;
  std::uint32_t seed_ = 1;
  BuildArguments building_;
  CommonOptions common_;
  Wish wish_;
  Progress progress_;
  ProgressBar *bar_ = nullptr;
  Stopwatch watch_;
  std::shared_ptr<WorkingMemory> memory_;
};

/// "180", "180s", "3m", "2h" in seconds; 0 for what is none of these.
double secondsOf(const std::string &text) {
  std::size_t end = 0;
  double value = 0;
  try {
    value = std::stod(text, &end);
  } catch (const std::exception &) {
    return 0;
  }
  static const std::map<std::string, double> kUnits = {
      {"", 1}, {"s", 1}, {"m", 60}, {"min", 60}, {"h", 3600}};
  const auto unit = kUnits.find(text.substr(end));
  return unit != kUnits.end() && value > 0 && value < 1e9 ? value * unit->second : 0;
}

void SearchCommand::declare(CLI::App &app) {
  app.add_option("INPUT", input_, kInputHelp)->required()->type_name("");
  addInputArguments(app, inputArguments_);
  app.get_option("--resolution")
      ->description("Voxels on the longest axis; default: " + std::to_string(kDefaultResolution));
  app.add_option("--budget", budgetText_, "Time that the search may take, such as 90s, 5m or 2h")
      ->type_name("TIME")
      ->capture_default_str();
  app.add_option("-o,--output", folder_, "Folder of results and volumes; an earlier search's is continued")
      ->required()
      ->type_name("DIR");
  app.add_option("--device", device_, "Device whose name contains this, or cpu; default: the best")
      ->type_name("NAME");
  app.add_option("--precision", precision_, "exact or fast")
      ->type_name("P")
      ->check(CLI::IsMember(std::vector<std::string>(kPrecisionAttribute.values.begin(),
                                                     kPrecisionAttribute.values.end()))
                  .description(""))
      ->capture_default_str();
  app.add_option("--objective", objective_,
                 "Whose command is told: balanced (default; twice the speed is worth four times the bytes), "
                 "fastest or smallest")
      ->type_name("WISH")
      ->check(CLI::IsMember(kObjectives).description(""));
  addMaxBytesArgument(app, building_);
  app.get_option("--max-bytes")->description("The most bytes that a volume's words may take, such as 64MiB");
  app.add_option("--min-speed", leastSpeed_, "The least speed that is of use, in million rays a second")
      ->type_name("M")
      ->check(CLI::NonNegativeNumber.description(""));
  app.add_option("--cameras", rays_.cameraFile,
                 "A camera file: its camera of the input's name, or all if there is none; default: one that "
                 "sees the whole volume, and rays from where it hits that go anywhere")
      ->type_name("FILE");
  app.add_option("--size", rays_.size, "Pixels of the cameras' pictures; default: the file's, or 480x270")
      ->type_name("WxH");
  app.add_option("--rays", rays_.rayFiles, "A file of rays; may be given several times")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("R.bin");
  app.add_option("--formats", formatsPath_, "A file of formats, one a line, to choose from and nothing else")
      ->type_name("FILE");
  app.add_option("--max-levels", explore_.maxLevels, "The most levels of a format")
      ->type_name("N")
      ->check(CLI::Range(1, 8).description(""))
      ->capture_default_str();
  app.add_option("--explore", explore_.mostFormats, "The most formats of which size and speed are foretold")
      ->type_name("N")
      ->check(CLI::Range(1, 10'000'000).description(""))
      ->capture_default_str();
  app.add_option("--check", check_, "Rays, evenly spread, on which errors are found; 0: none")
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--seed", seed_, "Of the rays that go anywhere")->type_name("N")->capture_default_str();
  app.add_option("--threads", building_.threads,
                 "Threads that build, and of a device that is this processor; default: all")
      ->type_name("N")
      ->check(CLI::Range(1u, 1024u).description(""));
  addMemoryArguments(app, building_);
  addCommonOptions(app, common_);
}

Expected<void> SearchCommand::checkUsage() {
  budget_ = secondsOf(budgetText_);
  if (budget_ <= 0)
    return Error::usage("--budget '" + budgetText_ + "' is no time; it should be such as 90s, 5m or 2h");
  wish_ = {kObjectives.at(objective_), std::min(maxWordsOf(building_), kMaxWords) * sizeof(std::uint32_t)};
  // Several volumes of a batch lie in memory together, on a device too.
  constexpr std::uint64_t kShare = 12;
  if (building_.maxBytes.empty())
    wish_.maxBytes = std::min(wish_.maxBytes, bench::machineMemory() / kShare);
  if (inputArguments_.resolution == 0)
    inputArguments_.resolution = kDefaultResolution;
  return makeOutputFolder(folder_ + "/cache");
}

/// What was typed, as far as it matters to who reads the records.
std::string SearchCommand::commandText() const {
  std::string text = "voxc search " + quoted(input_);
  for (const std::string &word : bench::toWords(inputArguments_))
    text += " " + word;
  return text + " --budget " + budgetText_ + " -o " + quoted(folder_);
}

/// Without others: a camera that sees everything, and rays from surface to surface, so that the answer is not
/// that of one view.
Expected<std::vector<bench::RaySet>> SearchCommand::measuredRays(const Scene &scene) const {
  bench::RayArguments arguments = rays_;
  const bool isUsual = arguments.cameraFile.empty() && arguments.rayFiles.empty();
  if (arguments.size.empty() && arguments.cameraFile.empty())
    arguments.size = "480x270";
  auto sets = bench::readRaySets(arguments, bench::nameOfInput(input_));
  if (!sets || !isUsual)
    return sets;
  std::vector<Ray> bounces = sampleBounces(scene.shape, sets->front().raysFor(scene.extent), seed_);
  if (!bounces.empty())
    sets->push_back(bench::makeRaySet("bounced", std::move(bounces)));
  return sets;
}

std::vector<RaySet> SearchCommand::replayedRays(const Scene &scene,
                                                const std::vector<bench::RaySet> &measured) const {
  std::vector<RaySet> sets;
  for (const bench::RaySet &set : measured)
    sets.push_back({set.part.name, set.camera ? sampleCamera(set.camera(scene.extent), kReplayedRays)
                                              : spreadPackets(set.rays)});
  return sets;
}

Expected<bench::SweepAxes> SearchCommand::readAxes(const Scene &scene) const {
  auto model = bench::readModel(input_, inputArguments_);
  if (!model)
    return model.error();
  auto rays = measuredRays(scene);
  if (!rays)
    return rays.error();
  auto devices = bench::findDevices({device_}, building_.threads);
  if (!devices)
    return devices.error();
  for (const bench::RaySet &set : *rays)
    if (Expected<void> kept = bench::keepRays(set, folder_ + "/cache"); !kept)
      return kept.error();
  std::vector<bench::SweepModel> models;
  models.push_back({std::move(*model), std::move(*rays)});
  return bench::SweepAxes{std::move(models), {}, {precision_}, std::move(*devices)};
}

Explored SearchCommand::foretell(const Scene &scene, const std::vector<RaySet> &rays, const SpeedModel &model,
                                 std::vector<Candidate> seeds) const {
  Rater rater(scene.priced());
  ExploreOptions options = explore_;
  if (!formatsPath_.empty()) {
    // They and no others: nothing is rewritten, nothing left out.
    options.mostFormats = seeds.size();
    options.kept = std::numeric_limits<double>::infinity();
  }
  return explore(rater, std::move(seeds), scene.traits, rays, model, wish_, options, progress_);
}

Expected<void> SearchCommand::tell(const SearchResult &result, Json &figures) {
  bar_->clear();
  addSearchFigures(figures, result);
  std::fputs(searchReport(result).c_str(), stdout);
  const auto cells = report::readCells({folder_});
  if (!cells)
    return cells.error();
  const report::Report report = report::makeReport(*cells, {});
  if (Expected<void> written = writeText(folder_ + "/report.html", report.html); !written)
    return written;
  if (!common_.quiet)
    printNote("wrote " + folder_ + "/report.html and " + folder_ + "/" + bench::kResultsName);
  return writeStatistics(common_.stats, figures);
}

Expected<void> SearchCommand::measure(Scene &scene, bench::SweepAxes &axes, Explored explored,
                                      const SpeedModel &model, Json &figures) {
  const auto smallest = std::ranges::min_element(explored.formats, {}, &RatedFormat::bytes);
  const double mostBytes = kSizesOfUse * static_cast<double>(smallest->bytes());
  const std::size_t kept = explored.formats.size();
  Race race(std::move(explored.formats), model, {.mostBytes = mostBytes, .leastSpeed = leastSpeed_});
  auto writer = bench::RecordWriter::open(folder_ + "/" + bench::kResultsName);
  if (!writer)
    return writer.error();
  const auto known = bench::readRecords(folder_);
  if (!known)
    return known.error();
  auto arena = Arena::create(scene, axes,
                             {.threads = threadsOf(building_),
                              .check = check_,
                              .maxBytes = wish_.maxBytes,
                              .folder = folder_,
                              .madeBy = bench::madeBy(commandText())},
                             memory_, progress_);
  if (!arena)
    return arena.error();
  Contest contest(race, *arena, *writer, {.seconds = budget_ - watch_.seconds()});
  contest.takeKnown(*known);
  const Expected<void> measured = contest.run(progress_);
  const bool isInterrupted = !measured && measured.error().kind == ErrorKind::Interrupted;
  if (!measured && !isInterrupted)
    return measured;
  if (!contest.findings().empty())
    if (Expected<void> kept = keepSpeedModel(axes.devices.front().part.name, race.model()); !kept)
      return kept;
  Expected<void> told = tell({.input = input_,
                              .arguments = inputArguments_,
                              .device = axes.devices.front().part.name,
                              .wish = wish_,
                              .rated = explored.rated,
                              .kept = kept,
                              .seconds = watch_.seconds(),
                              .race = race,
                              .contest = contest},
                             figures);
  return told ? measured : told;
}

Expected<void> SearchCommand::search(Scene &scene, Json &figures) {
  if (!scene.colours)
    return Error::environment("the scene with its colours takes more than the memory that may be used; "
                              "--memory allows more, and a lower --resolution takes less");
  auto axes = readAxes(scene);
  if (!axes)
    return axes.error();
  auto seeds = readCandidates(formatsPath_, scene);
  if (!seeds)
    return seeds.error();
  const SpeedModel model = speedModelFor(axes->devices.front().part.name);
  const Stopwatch exploring;
  Explored explored =
      foretell(scene, replayedRays(scene, axes->models.front().rays), model, std::move(*seeds));
  figures["explore_seconds"] = exploring.seconds();
  if (progress_.stopped())
    return Error::interrupted();
  if (explored.formats.empty())
    return Error::input("no format takes so few bytes as --max-bytes allows; a lower resolution would");
  return measure(scene, *axes, std::move(explored), model, figures);
}

Expected<void> SearchCommand::run() {
  watch_ = {};
  if (Expected<void> usable = checkUsage(); !usable)
    return usable;
  bench::disableShaderCaches();
  ProgressBar bar(common_.quiet);
  bar_ = &bar;
  progress_ = bar.progress();
  memory_ = makeWorkingMemory(building_);
  Json figures;
  Expected<Scene> scene = readScene(input_, inputArguments_, memory_, common_, progress_, figures);
  return scene ? search(*scene, figures) : scene.error();
}

} // namespace

std::unique_ptr<Subcommand> makeSearchCommand() { return std::make_unique<SearchCommand>(); }

} // namespace voxc::tool
