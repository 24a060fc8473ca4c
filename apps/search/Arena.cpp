// Building and tracing the formats of a search.
#include "search/Arena.h"

#include "search/KeptVolume.h"
#include "search/SearchCells.h"

#include "bench/Digest.h"
#include "common/Files.h"
#include "options/BuildFigures.h"
#include "sweep/Group.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/IR/Query.h"
#include "voxc/Search/SceneSource.h"
#include "voxc/Support/File.h"
#include "voxc/Support/Stopwatch.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <numeric>

namespace voxc::tool {

namespace fs = std::filesystem;
using bench::Failure;
using bench::Record;

namespace {

/// Rounds after which a format may be beaten: a first time alone may be bad luck.
constexpr unsigned kLeastRounds = 2;
/// What a name of a volume ends with, and that of what `voxc build --stats` would tell of it.
constexpr const char *kVolumeEnding = ".hvx", *kFormatEnding = ".vir", *kFiguresEnding = ".json";

/// The times of one set of rays.
struct SetTimes {
  Repeats cpuSeconds, seconds, deviceSeconds;
  std::string order;
};

/// What the device's clock counts.
const Repeats &clockOf(const SetTimes &times, const bench::DevicePart &device) {
  return device.clock == "gpu" ? times.deviceSeconds : times.cpuSeconds;
}

void takeLast(Repeats &from, Repeats &to) {
  if (!from.empty())
    to.push_back(from.back());
  from.clear();
}

} // namespace

/// A format on its way through the rounds.
struct Arena::Entrant {
  const RatedFormat *format;
  std::vector<Record> records; ///< Of each set.
  std::optional<Volume> volume;
  std::unique_ptr<Contestant> contestant;
  std::vector<SetTimes> times;
  std::optional<Failure> failure;
  bool isBeaten = false;
  bool isLate = false;     ///< There was no time to prepare it.
  unsigned rounds = 0;     ///< That it has been traced in, the first one not counted.
  double roundSeconds = 0; ///< That the last of them took.

  bool runs() const { return contestant && !failure && !isBeaten && !isLate; }
  void fail(const char *stage, const Error &error) {
    failure = {stage, error.message, {}};
    contestant.reset();
  }
  /// Nanoseconds a ray of a set, by its quickest round or its median.
  double nanoseconds(std::size_t set, double seconds) const {
    return 1e9 * seconds / static_cast<double>(records[set].rays.count);
  }
};

Expected<Arena> Arena::create(const Scene &scene, bench::SweepAxes &axes, ArenaOptions options,
                              const std::shared_ptr<WorkingMemory> &memory, const Progress &progress) {
  Arena arena(scene, axes, std::move(options), memory);
  const auto source = makeSceneSource(*scene.colours, scene.extent, scene.voxelToModel);
  Expected<Oracle> oracle = Oracle::of(*source, progress);
  if (!oracle)
    return oracle.error();
  arena.oracle_ = std::make_unique<Oracle>(std::move(*oracle));
  for (bench::RaySet &set : axes.models.front().rays) {
    bench::GroupRays rays = bench::makeGroupRays(set.raysFor(scene.extent), arena.options_.check);
    auto exact = arena.oracle_->trace(rays.sample, 0, progress);
    if (!exact)
      return exact.error();
    arena.rays_.push_back({std::move(rays.rays), std::move(rays.sample), std::move(*exact)});
  }
  return arena;
}

std::vector<Record> Arena::recordsOf(const RatedFormat &format) const {
  return tool::recordsOf(format.candidate, *axes_, options_.madeBy);
}

std::string Arena::volumePath(const RatedFormat &format) const {
  const std::string storage = printIr(storageFormat(format.candidate.format));
  const std::string key = bench::Digest().add(axes_->models.front().model.digest).add(storage).hex();
  return (fs::path(options_.folder) / "cache" / key).string() + kVolumeEnding;
}

void Arena::forget(const RatedFormat &format) const {
  fs::path path = volumePath(format);
  std::error_code ignored;
  for (const char *ending : {kVolumeEnding, kFormatEnding, kFiguresEnding})
    fs::remove(path.replace_extension(ending), ignored);
}

Expected<Volume> Arena::build(const RatedFormat &format, Record &record, const Progress &progress) {
  const std::string path = volumePath(format);
  const std::string figuresPath = fs::path(path).replace_extension(kFiguresEnding).string();
  Json figures;
  if (auto kept = loadKept(path, figuresPath, figures)) {
    addVolume(figures, record);
    return std::move(*kept);
  }
  const Format storage = storageFormat(format.candidate.format);
  const Stopwatch compiling;
  const auto constructor = Constructor::compile(storage);
  if (!constructor)
    return constructor.error();
  slowestCompile_ = std::max(slowestCompile_, compiling.seconds());
  const auto source = makeSceneSource(*scene_->colours, scene_->extent, scene_->voxelToModel);
  Expected<Built> built =
      constructor->build(*source, {.provenance = scene_->provenance,
                                   .threads = options_.threads,
                                   .memory = memory_,
                                   .path = path,
                                   .progress = progress.silent(),
                                   .maxWords = options_.maxBytes / sizeof(std::uint32_t)});
  if (!built)
    return built.error();
  const VolumeInfo &info = built->volume.info();
  figures = {{"words", built->volume.words().size()},
             {"bytes", built->volume.bytes()},
             {"voxels", info.voxels},
             {"extent", {info.extent.x, info.extent.y, info.extent.z}},
             {"compile_seconds", constructor->compileSeconds()}};
  addBuildFigures(figures, built->report);
  addFileFigure(figures, path);
  for (const auto &[name, text] :
       {std::pair(kFormatEnding, printIr(storage)), {kFiguresEnding, figures.dump() + "\n"}})
    if (auto written = writeText(fs::path(path).replace_extension(name).string(), text); !written)
      return written.error();
  addVolume(figures, record);
  return std::move(built->volume);
}

Expected<void> Arena::prepare(Entrant &entrant, const Heat &heat, const Progress &progress) {
  entrant.times.resize(rays_.size());
  Record &first = entrant.records.front();
  Expected<Volume> volume = build(*entrant.format, first, progress);
  if (progress.stopped())
    return Error::interrupted();
  if (!volume) {
    entrant.fail("build", volume.error());
    return {};
  }
  if (!heat.budget.allows(slowestCompile_))
    return Error::interrupted();
  for (Record &record : entrant.records) {
    record.volume = first.volume;
    record.build = first.build;
    record.model = first.model;
  }
  entrant.volume = std::move(*volume);
  Format kernel = entrant.format->candidate.format;
  askForPrecision(kernel, axes_->precisions.front());
  const Stopwatch watch;
  auto contestant = tool::prepare({.precision = axes_->precisions.front(),
                                   .device = axes_->devices.front().asked,
                                   .format = std::move(kernel)},
                                  *entrant.volume, options_.threads,
                                  entrant.records.front().rays.order.value_or(kAutoOrder));
  slowestCompile_ = std::max(slowestCompile_, watch.seconds());
  if (contestant)
    entrant.contestant = std::move(*contestant);
  else
    entrant.fail("compile", contestant.error());
  return {};
}

Expected<void> Arena::traceRound(Entrant &entrant, bool counted, const Progress &progress) const {
  for (std::size_t set = 0; set < rays_.size(); ++set) {
    Contestant &contestant = *entrant.contestant;
    const auto traced = traceOnce(contestant, rays_[set].rays, counted, progress);
    if (progress.stopped())
      return Error::interrupted();
    if (!traced) {
      entrant.fail("trace", traced.error());
      return {};
    }
    SetTimes &times = entrant.times[set];
    takeLast(contestant.cpuSeconds, times.cpuSeconds);
    takeLast(contestant.seconds, times.seconds);
    takeLast(contestant.deviceSeconds, times.deviceSeconds);
    times.order = contestant.order;
    if (counted)
      continue;
    // The round that warms leaves the hits.
    const MeasuredRays &rays = rays_[set];
    std::vector<Hit> hits(rays.sample.size());
    for (std::size_t i = 0; i < hits.size(); ++i)
      hits[i] = contestant.hits[i * rays.rays.size() / hits.size()];
    entrant.records[set].error = bench::partOf(compare(*oracle_, rays.sample, rays.exact, hits));
    entrant.records[set].work.hits =
        static_cast<std::uint64_t>(std::ranges::count_if(contestant.hits, &Hit::isHit));
  }
  return {};
}

Expected<void> Arena::examine(Entrant &entrant, const Heat &heat) const {
  // Words are counted by another kernel.
  if (!heat.countsWork || !heat.budget.allows(2 * slowestCompile_))
    return {};
  Json ignored;
  Tracing &tracing = entrant.contestant->tracing;
  const auto countOn = [&](const TraceOptions &options,
                           bench::Figure bench::WorkPart::*figure) -> Expected<void> {
    for (std::size_t set = 0; set < rays_.size(); ++set) {
      std::vector<Hit> hits(rays_[set].sample.size());
      if (auto traced = tracing.trace(rays_[set].sample, hits, options, ignored); !traced)
        return traced;
      entrant.records[set].work.rays = hits.size();
      entrant.records[set].work.*figure = bench::meanSteps(hits);
    }
    return {};
  };
  if (auto counted = countOn({.countSteps = true}, &bench::WorkPart::stepsPerRay); !counted)
    return counted;
  if (auto prepared = tracing.prepareToCountWords(*entrant.volume, entrant.contestant->variant.format);
      !prepared)
    return prepared;
  return countOn({.countWords = true}, &bench::WorkPart::wordsPerRay);
}

Finding Arena::finish(Entrant &entrant) const {
  Finding finding{std::move(entrant.records), {}};
  for (std::size_t set = 0; set < finding.records.size(); ++set) {
    Record &record = finding.records[set];
    record.failure = entrant.failure;
    if (entrant.failure)
      continue;
    const SetTimes &times = entrant.times[set];
    const std::uint64_t count = record.rays.count;
    const auto figure = [&setup = entrant.contestant->setup](const char *key) {
      return setup.contains(key) ? bench::Figure(setup[key].get<double>()) : std::nullopt;
    };
    record.kernel = {figure("kernel_seconds"), figure("upload_seconds"),
                     entrant.contestant->firstDispatchSeconds};
    record.speed = {times.seconds.size(),
                    bench::speedOf(count, times.seconds),
                    bench::speedOf(count, times.cpuSeconds),
                    bench::speedOf(count, times.deviceSeconds),
                    spread(clockOf(times, record.device)) <= bench::MeasureOptions{}.steady,
                    times.order};
    finding.nanoseconds.push_back(1e9 * median(clockOf(times, record.device)) / static_cast<double>(count));
  }
  return finding;
}

Expected<void> Arena::traceRounds(std::vector<Entrant> &entrants, const Heat &heat,
                                  const Progress &progress) const {
  for (unsigned round = 0; round <= heat.rounds; ++round)
    for (Entrant &entrant : entrants) {
      if (!entrant.runs())
        continue;
      progress.at("measure", 0);
      if (!heat.budget.allows(entrant.roundSeconds))
        return Error::interrupted();
      const Stopwatch watch;
      if (Expected<void> traced = traceRound(entrant, round > 0, progress); !traced)
        return traced.error();
      entrant.rounds = round;
      entrant.roundSeconds = watch.seconds();
      if (round < kLeastRounds || !heat.isBeaten || !entrant.runs())
        continue;
      double least = 0;
      for (std::size_t set = 0; set < rays_.size(); ++set)
        least += entrant.nanoseconds(
            set, std::ranges::min(clockOf(entrant.times[set], entrant.records[set].device)));
      entrant.isBeaten = heat.isBeaten(static_cast<double>(entrant.format->bytes()),
                                       least / static_cast<double>(rays_.size()));
    }
  return {};
}

Expected<std::vector<Finding>> Arena::measure(std::span<const RatedFormat *const> formats,
                                              std::span<const std::vector<double>> predicted,
                                              const Heat &heat, const Progress &progress) {
  const Progress bounded = heat.budget.within(progress);
  std::vector<Entrant> entrants;
  for (std::size_t i = 0; i < formats.size(); ++i) {
    Entrant &entrant = entrants.emplace_back(Entrant{formats[i], recordsOf(*formats[i]), {}, {}, {}, {}});
    for (std::size_t set = 0; set < entrant.records.size(); ++set)
      entrant.records[set].predicted = {formats[i]->price.words(), 1000 / predicted[i][set],
                                        formats[i]->costs[set].turns, formats[i]->costs[set].lines};
    progress.at("measure", 0);
    if (!bounded.stopped())
      entrant.isLate = !prepare(entrant, heat, bounded);
    else
      entrant.isLate = true;
  }
  // What the budget ends keeps the rounds that were finished.
  static_cast<void>(traceRounds(entrants, heat, bounded));
  if (progress.stopped())
    return Error::interrupted();
  std::vector<Finding> findings;
  for (Entrant &entrant : entrants) {
    if (!entrant.failure && (entrant.isLate || entrant.rounds < heat.leastRounds)) {
      findings.emplace_back();
      continue;
    }
    if (entrant.contestant && !entrant.failure)
      if (const auto examined = examine(entrant, heat); !examined)
        entrant.fail("trace", examined.error());
    findings.push_back(finish(entrant));
  }
  return findings;
}

} // namespace voxc::tool
