// Building and tracing the formats of a search.
#include "search/MeasurementSession.h"

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
struct MeasurementSession::MeasuredFormat {
  const PredictedFormat *format;
  std::vector<Record> records; ///< Of each set.
  std::optional<Volume> volume;
  std::unique_ptr<VariantCandidate> candidate;
  std::vector<SetTimes> times;
  std::optional<Failure> failure;
  bool isBeaten = false;
  bool isLate = false;     ///< There was no time to prepare it.
  unsigned rounds = 0;     ///< That it has been traced in, the first one not counted.
  double roundSeconds = 0; ///< That the last of them took.

  bool runs() const { return candidate && !failure && !isBeaten && !isLate; }
  void fail(const char *stage, const Error &error) {
    failure = {stage, error.message, {}};
    candidate.reset();
  }
  /// Nanoseconds a ray of a set, by its quickest round or its median.
  double nanoseconds(std::size_t set, double seconds) const {
    return 1e9 * seconds / static_cast<double>(records[set].rays.count);
  }
};

Expected<MeasurementSession> MeasurementSession::create(const Scene &scene, bench::SweepAxes &axes,
                                                        MeasurementOptions options,
                                                        const std::shared_ptr<WorkingMemory> &memory,
                                                        const Progress &progress) {
  MeasurementSession session(scene, axes, std::move(options), memory);
  const auto source = makeSceneSource(*scene.colours, scene.extent, scene.voxelToModel);
  Expected<Oracle> oracle = Oracle::of(*source, progress);
  if (!oracle)
    return oracle.error();
  session.oracle_ = std::make_unique<Oracle>(std::move(*oracle));
  for (bench::RaySet &set : axes.models.front().rays) {
    bench::GroupRays rays = bench::makeGroupRays(set.raysFor(scene.extent), session.options_.check);
    auto exact = session.oracle_->trace(rays.sample, 0, progress);
    if (!exact)
      return exact.error();
    session.rays_.push_back({std::move(rays.rays), std::move(rays.sample), std::move(*exact)});
  }
  return session;
}

std::vector<Record> MeasurementSession::recordsOf(const PredictedFormat &format) const {
  return tool::recordsOf(format.candidate, *axes_, options_.madeBy);
}

std::string MeasurementSession::volumePath(const PredictedFormat &format) const {
  const std::string storage = printIr(storageFormat(format.candidate.format));
  const std::string key = bench::Digest().add(axes_->models.front().model.digest).add(storage).hex();
  return (fs::path(options_.folder) / "cache" / key).string() + kVolumeEnding;
}

void MeasurementSession::forget(const PredictedFormat &format) const {
  fs::path path = volumePath(format);
  std::error_code ignored;
  for (const char *ending : {kVolumeEnding, kFormatEnding, kFiguresEnding})
    fs::remove(path.replace_extension(ending), ignored);
}

Expected<Volume> MeasurementSession::build(const PredictedFormat &format, Record &record,
                                           const Progress &progress) {
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

Expected<void> MeasurementSession::prepare(MeasuredFormat &measured, const RoundOptions &roundOptions,
                                           const Progress &progress) {
  measured.times.resize(rays_.size());
  Record &first = measured.records.front();
  Expected<Volume> volume = build(*measured.format, first, progress);
  if (progress.stopped())
    return Error::interrupted();
  if (!volume) {
    measured.fail("build", volume.error());
    return {};
  }
  if (!roundOptions.budget.allows(slowestCompile_))
    return Error::interrupted();
  for (Record &record : measured.records) {
    record.volume = first.volume;
    record.build = first.build;
    record.model = first.model;
  }
  measured.volume = std::move(*volume);
  Format kernel = measured.format->candidate.format;
  askForPrecision(kernel, axes_->precisions.front());
  const Stopwatch watch;
  auto candidate = tool::prepare({.precision = axes_->precisions.front(),
                                  .device = axes_->devices.front().asked,
                                  .format = std::move(kernel)},
                                 *measured.volume, options_.threads,
                                 measured.records.front().rays.order.value_or(kAutoOrder));
  slowestCompile_ = std::max(slowestCompile_, watch.seconds());
  if (candidate)
    measured.candidate = std::move(*candidate);
  else
    measured.fail("compile", candidate.error());
  return {};
}

Expected<void> MeasurementSession::traceRound(MeasuredFormat &measured, bool counted,
                                              const Progress &progress) const {
  for (std::size_t set = 0; set < rays_.size(); ++set) {
    VariantCandidate &candidate = *measured.candidate;
    const auto traced = traceOnce(candidate, rays_[set].rays, counted, progress);
    if (progress.stopped())
      return Error::interrupted();
    if (!traced) {
      measured.fail("trace", traced.error());
      return {};
    }
    SetTimes &times = measured.times[set];
    takeLast(candidate.cpuSeconds, times.cpuSeconds);
    takeLast(candidate.seconds, times.seconds);
    takeLast(candidate.deviceSeconds, times.deviceSeconds);
    times.order = candidate.order;
    if (counted)
      continue;
    // The round that warms leaves the hits.
    const MeasuredRays &rays = rays_[set];
    std::vector<Hit> hits(rays.sample.size());
    for (std::size_t i = 0; i < hits.size(); ++i)
      hits[i] = candidate.hits[i * rays.rays.size() / hits.size()];
    measured.records[set].error = bench::partOf(compare(*oracle_, rays.sample, rays.exact, hits));
    measured.records[set].work.hits =
        static_cast<std::uint64_t>(std::ranges::count_if(candidate.hits, &Hit::isHit));
  }
  return {};
}

Expected<void> MeasurementSession::examine(MeasuredFormat &measured, const RoundOptions &roundOptions) const {
  // Words are counted by another kernel.
  if (!roundOptions.countsWork || !roundOptions.budget.allows(2 * slowestCompile_))
    return {};
  Json ignored;
  TraceSession &tracing = measured.candidate->tracing;
  const auto countOn = [&](const TraceOptions &options,
                           bench::Figure bench::WorkPart::*figure) -> Expected<void> {
    for (std::size_t set = 0; set < rays_.size(); ++set) {
      std::vector<Hit> hits(rays_[set].sample.size());
      if (auto traced = tracing.trace(rays_[set].sample, hits, options, ignored); !traced)
        return traced;
      measured.records[set].work.rays = hits.size();
      measured.records[set].work.*figure = bench::meanSteps(hits);
    }
    return {};
  };
  if (auto counted = countOn({.countSteps = true}, &bench::WorkPart::stepsPerRay); !counted)
    return counted;
  if (auto prepared = tracing.prepareToCountWords(*measured.volume, measured.candidate->variant.format);
      !prepared)
    return prepared;
  return countOn({.countWords = true}, &bench::WorkPart::wordsPerRay);
}

Finding MeasurementSession::finish(MeasuredFormat &measured) const {
  Finding finding{std::move(measured.records), {}};
  for (std::size_t set = 0; set < finding.records.size(); ++set) {
    Record &record = finding.records[set];
    record.failure = measured.failure;
    if (measured.failure)
      continue;
    const SetTimes &times = measured.times[set];
    const std::uint64_t count = record.rays.count;
    const auto figure = [&setup = measured.candidate->setup](const char *key) {
      return setup.contains(key) ? bench::Figure(setup[key].get<double>()) : std::nullopt;
    };
    record.kernel = {figure("kernel_seconds"), figure("upload_seconds"),
                     measured.candidate->firstDispatchSeconds};
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

Expected<void> MeasurementSession::traceRounds(std::vector<MeasuredFormat> &allMeasured,
                                               const RoundOptions &roundOptions,
                                               const Progress &progress) const {
  for (unsigned round = 0; round <= roundOptions.rounds; ++round)
    for (MeasuredFormat &measured : allMeasured) {
      if (!measured.runs())
        continue;
      progress.at("measure", 0);
      if (!roundOptions.budget.allows(measured.roundSeconds))
        return Error::interrupted();
      const Stopwatch watch;
      if (Expected<void> traced = traceRound(measured, round > 0, progress); !traced)
        return traced.error();
      measured.rounds = round;
      measured.roundSeconds = watch.seconds();
      if (round < kLeastRounds || !roundOptions.isBeaten || !measured.runs())
        continue;
      double least = 0;
      for (std::size_t set = 0; set < rays_.size(); ++set)
        least += measured.nanoseconds(
            set, std::ranges::min(clockOf(measured.times[set], measured.records[set].device)));
      measured.isBeaten = roundOptions.isBeaten(static_cast<double>(measured.format->bytes()),
                                                least / static_cast<double>(rays_.size()));
    }
  return {};
}

Expected<std::vector<Finding>> MeasurementSession::measure(std::span<const PredictedFormat *const> formats,
                                                           std::span<const std::vector<double>> predicted,
                                                           const RoundOptions &roundOptions,
                                                           const Progress &progress) {
  const Progress bounded = roundOptions.budget.within(progress);
  std::vector<MeasuredFormat> allMeasured;
  for (std::size_t i = 0; i < formats.size(); ++i) {
    MeasuredFormat &measured =
        allMeasured.emplace_back(MeasuredFormat{formats[i], recordsOf(*formats[i]), {}, {}, {}, {}});
    for (std::size_t set = 0; set < measured.records.size(); ++set)
      measured.records[set].predicted = {formats[i]->price.words(), 1000 / predicted[i][set],
                                         formats[i]->costs[set].turns, formats[i]->costs[set].lines};
    progress.at("measure", 0);
    if (!bounded.stopped())
      measured.isLate = !prepare(measured, roundOptions, bounded);
    else
      measured.isLate = true;
  }
  // What the budget ends keeps the rounds that were finished.
  static_cast<void>(traceRounds(allMeasured, roundOptions, bounded));
  if (progress.stopped())
    return Error::interrupted();
  std::vector<Finding> findings;
  for (MeasuredFormat &measured : allMeasured) {
    if (!measured.failure && (measured.isLate || measured.rounds < roundOptions.leastRounds)) {
      findings.emplace_back();
      continue;
    }
    if (measured.candidate && !measured.failure)
      if (const auto examined = examine(measured, roundOptions); !examined)
        measured.fail("trace", examined.error());
    findings.push_back(finish(measured));
  }
  return findings;
}

} // namespace voxc::tool
