// Building and tracing the formats of a search.
#include "voxc/Measure/MeasurementSession.h"

#include "Measure/KeptVolume.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/IR/Query.h"
#include "voxc/Measure/Digest.h"
#include "voxc/Search/SceneSource.h"
#include "voxc/Support/Stopwatch.h"

#include <algorithm>
#include <filesystem>

namespace voxc::measure {

namespace fs = std::filesystem;

namespace {

/// Rounds after which a format may be beaten: a first time alone may be bad luck.
constexpr unsigned kLeastRounds = 2;

} // namespace

/// A format on its way through the rounds.
struct MeasurementSession::MeasuredFormat {
  const PredictedFormat *format;
  std::vector<Record> records; ///< Of each set.
  std::optional<Volume> volume;
  std::optional<Subject> subject;
  std::vector<Times> times; ///< Of each set.
  std::optional<Failure> failure;
  bool isBeaten = false;
  bool isLate = false;     ///< There was no time to prepare it.
  unsigned rounds = 0;     ///< That it has been traced in, the first one not counted.
  double roundSeconds = 0; ///< That the last of them took.

  bool runs() const { return subject && !failure && !isBeaten && !isLate; }
  void fail(const char *stage, const Error &error) {
    failure = {stage, error.message, {}};
    subject.reset();
  }
};

Expected<MeasurementSession> MeasurementSession::create(const SearchScene &scene,
                                                        std::vector<MeasuredSet> sets,
                                                        MeasurementOptions options,
                                                        const Progress &progress) {
  MeasurementSession session(scene, std::move(options));
  const auto source = makeSceneSource(*scene.colours, scene.extent, scene.voxelToModel);
  auto oracle = VOXC_TRY(Oracle::of(*source, progress));
  session.oracle_ = std::make_unique<Oracle>(std::move(oracle));
  for (MeasuredSet &set : sets) {
    SampledRays rays = sampleRays(std::move(set.rays), session.options_.check);
    rays.exact = VOXC_TRY(session.oracle_->trace(rays.sample, 0, progress));
    session.rays_.push_back(std::move(rays));
  }
  session.sets_ = std::move(sets);
  return session;
}

std::vector<Record> MeasurementSession::recordsOf(const Candidate &format) const {
  Format kernel = format.format;
  askForPrecision(kernel, options_.precision);
  std::vector<Record> records;
  for (const MeasuredSet &set : sets_) {
    Record &record = records.emplace_back();
    record.model = options_.model;
    record.format = formatPart("", format.text, format.passes, kernel);
    record.resolution = longestAxis(format.format);
    record.precision = options_.precision;
    record.device = device_;
    record.rays = set.part;
    record.madeBy = options_.madeBy;
    record.cell = cellDigest(record);
  }
  return records;
}

std::string MeasurementSession::volumePath(const PredictedFormat &format) const {
  const std::string storage = printIr(storageFormat(format.candidate.format));
  const std::string key = Digest().add(options_.model.digest).add(storage).hex();
  return (fs::path(options_.folder) / key).string() + kVolumeEnding;
}

void MeasurementSession::forget(const PredictedFormat &format) const {
  fs::path path = volumePath(format);
  std::error_code ignored;
  for (const char *ending : {kVolumeEnding, kFormatEnding, kFiguresEnding})
    fs::remove(path.replace_extension(ending), ignored);
}

const Repeats &MeasurementSession::clockOf(const Times &times) const {
  return device_.clock == "gpu" ? times.deviceSeconds : times.cpuSeconds;
}

Expected<Volume> MeasurementSession::build(const PredictedFormat &format, Record &record,
                                           const Progress &progress) {
  const std::string path = volumePath(format);
  if (auto kept = loadKept(path, record))
    return std::move(*kept);
  const Format storage = storageFormat(format.candidate.format);
  const Stopwatch compiling;
  const auto constructor = VOXC_TRY(Constructor::compile(storage));
  slowestCompile_ = std::max(slowestCompile_, compiling.seconds());
  const auto source = makeSceneSource(*scene_->colours, scene_->extent, scene_->voxelToModel);
  auto built = VOXC_TRY(constructor.build(*source, {.provenance = options_.provenance,
                                                    .threads = options_.threads,
                                                    .memory = options_.memory,
                                                    .path = path,
                                                    .progress = progress.silent(),
                                                    .maxWords = options_.maxBytes / sizeof(std::uint32_t)}));
  VOXC_TRY(keepBuild(path, storage, built, constructor.compileSeconds(), record));
  return std::move(built.volume);
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
  askForPrecision(kernel, options_.precision);
  const Stopwatch watch;
  auto subject =
      Subject::open(*measured.volume, kernel,
                    {.device = options_.device, .threads = options_.threads, .order = sets_.front().order()});
  slowestCompile_ = std::max(slowestCompile_, watch.seconds());
  if (subject)
    measured.subject = std::move(*subject);
  else
    measured.fail("compile", subject.error());
  return {};
}

Expected<void> MeasurementSession::traceRound(MeasuredFormat &measured, bool counted,
                                              const Progress &progress) const {
  for (std::size_t set = 0; set < rays_.size(); ++set) {
    const SampledRays &rays = rays_[set];
    const auto traced =
        measured.subject->trace(rays.rays, counted ? &measured.times[set] : nullptr, progress);
    if (progress.stopped())
      return Error::interrupted();
    if (!traced) {
      measured.fail("trace", traced.error());
      return {};
    }
    if (counted)
      continue;
    // The round that warms leaves the hits.
    const std::span<const Hit> hits = measured.subject->hits();
    Record &record = measured.records[set];
    record.error = errorPart(compare(*oracle_, rays.sample, rays.exact, rays.sampleOf(hits)));
    record.work.hits = static_cast<std::uint64_t>(std::ranges::count_if(hits, &Hit::isHit));
  }
  return {};
}

Expected<void> MeasurementSession::examine(MeasuredFormat &measured, const RoundOptions &roundOptions) const {
  // Words are counted by another kernel.
  if (!roundOptions.countsWork || !roundOptions.budget.allows(2 * slowestCompile_))
    return {};
  for (std::size_t set = 0; set < rays_.size(); ++set) {
    const std::vector<Ray> &sample = rays_[set].sample;
    const auto steps = VOXC_TRY(measured.subject->stepsPerRay(sample));
    const auto words = VOXC_TRY(measured.subject->wordsPerRay(sample));
    WorkPart &work = measured.records[set].work;
    work.rays = sample.size();
    work.stepsPerRay = steps;
    work.wordsPerRay = words;
  }
  return {};
}

Finding MeasurementSession::finish(MeasuredFormat &measured) const {
  Finding finding{std::move(measured.records), {}};
  for (std::size_t set = 0; set < finding.records.size(); ++set) {
    Record &record = finding.records[set];
    record.failure = measured.failure;
    if (measured.failure)
      continue;
    const Times &times = measured.times[set];
    const std::uint64_t count = record.rays.count;
    record.kernel = {measured.subject->opened().kernelSeconds, measured.subject->opened().uploadSeconds,
                     measured.subject->firstDispatchSeconds()};
    record.speed = {times.seconds.size(),
                    speedOf(count, times.seconds),
                    speedOf(count, times.cpuSeconds),
                    speedOf(count, times.deviceSeconds),
                    spread(clockOf(times)) <= kSteadySpread,
                    times.isBinned ? "binned" : "given"};
    finding.nanoseconds.push_back(1e9 * median(clockOf(times)) / static_cast<double>(count));
  }
  return finding;
}

/// Nanoseconds a ray, by the quickest round of each set.
double MeasurementSession::quickest(const MeasuredFormat &measured) const {
  double sum = 0;
  for (std::size_t set = 0; set < rays_.size(); ++set)
    sum += 1e9 * std::ranges::min(clockOf(measured.times[set])) / static_cast<double>(rays_[set].rays.size());
  return sum / static_cast<double>(rays_.size());
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
      VOXC_TRY(traceRound(measured, round > 0, progress));
      measured.rounds = round;
      measured.roundSeconds = watch.seconds();
      if (round < kLeastRounds || !roundOptions.isBeaten || !measured.runs())
        continue;
      measured.isBeaten =
          roundOptions.isBeaten(static_cast<double>(measured.format->bytes()), quickest(measured));
    }
  return {};
}

Expected<std::vector<Finding>> MeasurementSession::measure(std::span<const PredictedFormat *const> formats,
                                                           std::span<const std::vector<double>> predicted,
                                                           const RoundOptions &roundOptions,
                                                           const Progress &progress) {
  const Progress bounded = roundOptions.budget.within(progress);
  // Subjects point to volumes that lie beside them.
  std::vector<MeasuredFormat> allMeasured;
  allMeasured.reserve(formats.size());
  for (std::size_t i = 0; i < formats.size(); ++i) {
    MeasuredFormat &measured = allMeasured.emplace_back(
        MeasuredFormat{formats[i], recordsOf(formats[i]->candidate), {}, {}, {}, {}});
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
    if (measured.subject && !measured.failure)
      if (const auto examined = examine(measured, roundOptions); !examined)
        measured.fail("trace", examined.error());
    findings.push_back(finish(measured));
  }
  return findings;
}

} // namespace voxc::measure
