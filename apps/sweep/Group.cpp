// Tracing a group.
#include "sweep/Group.h"

#include "accuracy/Variant.h"

#include "common/Png.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

namespace voxc::tool::bench {
namespace {

/// A cell on its way through the rounds.
struct Runner {
  Cell *cell;
  std::shared_ptr<const Volume> volume;
  std::unique_ptr<VariantCandidate> candidate; ///< Null: not prepared.
  std::optional<Failure> failure;
  WorkPart work;
  ErrorPart error;

  bool runs() const { return candidate && !failure; }
  void fail(const char *stage, const Error &error) {
    failure = {stage, error.message, volume ? Count(volume->words().size()) : std::nullopt};
  }
};

class Group {
public:
  Group(const GroupRays &rays, const MeasureOptions &options) : rays_(rays), options_(options) {}

  Expected<void> prepare(std::span<const BuiltCell> builtCells);
  /// A round that warms, then those that count.
  Expected<void> traceRounds();
  /// Errors, steps and words.
  Expected<void> examine();
  void takePicture(const std::string &path, const Camera &camera);
  /// Puts what was found into the records.
  void record() const;

private:
  /// Ends the sweep if it was interrupted; else the failure is the runner's.
  Expected<void> recordFailure(Runner &runner, const char *stage, const Expected<void> &outcome) const;
  Expected<void> prepareOne(Runner &runner, const std::string &path);
  Expected<void> examineOne(Runner &runner) const;
  bool isSteady(const Cell &cell) const;

  const GroupRays &rays_;
  const MeasureOptions &options_;
  std::map<std::string, std::shared_ptr<const Volume>> volumes_;
  std::vector<Runner> runners_;
};

Expected<void> Group::recordFailure(Runner &runner, const char *stage, const Expected<void> &outcome) const {
  if (options_.progress.stopped())
    return Error::interrupted();
  if (!outcome)
    runner.fail(stage, outcome.error());
  return {};
}

Expected<void> Group::prepareOne(Runner &runner, const std::string &path) {
  std::shared_ptr<const Volume> &volume = volumes_[path];
  if (!volume) {
    // It was written by a process of this sweep, and a checksum tells whether it is still that.
    Expected<Volume> loaded = Volume::load(path, {.trusted = true});
    if (!loaded) {
      // The next run builds it anew.
      std::error_code ignored;
      std::filesystem::remove(path, ignored);
      return loaded.error();
    }
    volume = std::make_shared<const Volume>(std::move(*loaded));
  }
  runner.volume = volume;
  const Cell &cell = *runner.cell;
  auto candidate = tool::prepare({.precision = cell.record.precision,
                                  .traversal = "",
                                  .device = cell.device->asked,
                                  .format = cell.kernelFormat},
                                 *volume, options_.threads, cell.record.rays.order.value_or(kAutoOrder));
  if (!candidate)
    return candidate.error();
  runner.candidate = std::move(*candidate);
  return {};
}

Expected<void> Group::prepare(std::span<const BuiltCell> builtCells) {
  for (const BuiltCell &built : builtCells) {
    runners_.push_back({.cell = built.cell});
    Runner &runner = runners_.back();
    if (auto recorded = recordFailure(runner, "compile", prepareOne(runner, built.volume.path)); !recorded)
      return recorded;
    options_.advance();
  }
  return {};
}

Expected<void> Group::traceRounds() {
  for (unsigned round = 0; round <= options_.rounds; ++round)
    for (Runner &runner : runners_) {
      if (runner.runs()) {
        const auto traced = traceOnce(*runner.candidate, rays_.rays, round > 0, options_.progress);
        if (auto recorded = recordFailure(runner, "trace", traced); !recorded)
          return recorded;
      }
      options_.advance();
    }
  return {};
}

Expected<void> Group::examineOne(Runner &runner) const {
  VariantCandidate &candidate = *runner.candidate;
  runner.work.hits = static_cast<std::uint64_t>(std::ranges::count_if(candidate.hits, &Hit::isHit));
  const std::size_t count = rays_.sample.size();
  if (count == 0)
    return {};
  std::vector<Hit> hits(count);
  for (std::size_t i = 0; i < count; ++i)
    hits[i] = candidate.hits[i * rays_.rays.size() / count];
  if (rays_.oracle)
    runner.error = partOf(compare(*rays_.oracle, rays_.sample, rays_.exact, hits));
  Json ignored;
  if (auto traced = candidate.tracing.trace(rays_.sample, hits, {.countSteps = true}, ignored); !traced)
    return traced;
  runner.work.rays = count;
  runner.work.stepsPerRay = meanSteps(hits);
  const Format &format = runner.cell->kernelFormat;
  if (auto prepared = candidate.tracing.prepareToCountWords(*runner.volume, format); !prepared)
    return prepared;
  if (auto traced = candidate.tracing.trace(rays_.sample, hits, {.countWords = true}, ignored); !traced)
    return traced;
  runner.work.wordsPerRay = meanSteps(hits);
  return {};
}

Expected<void> Group::examine() {
  for (Runner &runner : runners_) {
    if (runner.runs())
      if (auto recorded = recordFailure(runner, "trace", examineOne(runner)); !recorded)
        return recorded;
    options_.advance();
  }
  return {};
}

void Group::takePicture(const std::string &path, const Camera &camera) {
  const auto first = std::ranges::find_if(runners_, &Runner::runs);
  if (path.empty() || first == runners_.end())
    return;
  const std::vector<Ray> rays = cameraRays(camera);
  std::vector<Hit> hits(rays.size());
  Json ignored;
  // A picture is no finding: a sweep without it is whole.
  if (first->candidate->tracing.trace(rays, hits, {}, ignored))
    static_cast<void>(writePng(path, shade(rays, hits, camera.width, camera.height)));
}

bool Group::isSteady(const Cell &cell) const {
  const std::optional<Speed> &speed = speedOf(cell.record);
  if (!speed || speed->spread > options_.steady)
    return false;
  const std::optional<Speed> &before = cell.before ? speedOf(*cell.before) : speed;
  return !before || std::abs(speed->median - before->median) <= options_.steady * before->median;
}

Figure figureOf(const Json &figures, const char *key) {
  const auto entry = figures.find(key);
  return entry != figures.end() && entry->is_number() ? Figure(entry->get<double>()) : std::nullopt;
}

void Group::record() const {
  for (const Runner &runner : runners_) {
    Record &record = runner.cell->record;
    record.failure = runner.failure;
    if (runner.failure)
      continue;
    const VariantCandidate &candidate = *runner.candidate;
    const std::uint64_t count = rays_.rays.size();
    record.kernel = {figureOf(candidate.setup, "kernel_seconds"), figureOf(candidate.setup, "upload_seconds"),
                     candidate.firstDispatchSeconds};
    record.speed = {options_.rounds,
                    speedOf(count, candidate.seconds),
                    speedOf(count, candidate.cpuSeconds),
                    speedOf(count, candidate.deviceSeconds),
                    {},
                    candidate.order};
    record.work = runner.work;
    record.error = runner.error;
    record.speed.steady = isSteady(*runner.cell);
  }
}

} // namespace

double meanSteps(std::span<const Hit> hits) {
  double steps = 0;
  for (const Hit &hit : hits)
    steps += hit.steps;
  return steps / static_cast<double>(hits.size());
}

ErrorPart partOf(const ErrorFigures &error) {
  return {error.rays,   error.missed, error.ghost, error.wrong,   error.boundary,
          error.colour, error.maxDt,  error.rmsDt, error.maxUlpDt};
}

GroupRays makeGroupRays(std::vector<Ray> rays, std::size_t count) {
  GroupRays result{.rays = std::move(rays)};
  const std::size_t sample = std::min(count, result.rays.size());
  for (std::size_t i = 0; i < sample; ++i)
    result.sample.push_back(result.rays[i * result.rays.size() / sample]);
  return result;
}

std::size_t stepsOf(std::size_t cells, const MeasureOptions &options) {
  // Preparing, the round that warms, and examining are one each.
  return cells * (options.rounds + 3);
}

Expected<void> measure(std::span<const BuiltCell> builtCells, const GroupRays &rays,
                       const MeasureOptions &options, const std::string &picture, const Camera &camera) {
  Group group(rays, options);
  if (auto prepared = group.prepare(builtCells); !prepared)
    return prepared;
  if (auto traced = group.traceRounds(); !traced)
    return traced;
  // Before words are counted, after which nothing else can be done.
  group.takePicture(picture, camera);
  if (auto examined = group.examine(); !examined)
    return examined;
  group.record();
  return {};
}

} // namespace voxc::tool::bench
