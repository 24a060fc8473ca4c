// Tracing a group.
#include "sweep/Group.h"

#include "common/PictureFile.h"
#include "voxc/Measure/Subject.h"

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
  std::optional<Subject> subject; ///< None: not prepared.
  Times times;
  std::optional<Failure> failure;
  WorkPart work;
  ErrorPart error;

  bool runs() const { return subject && !failure; }
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
  Devices devices_; ///< Outlive what is traced on them.
  std::map<std::string, std::shared_ptr<const Volume>> volumes_;
  std::vector<Runner> runners_;
};

Expected<void> Group::recordFailure(Runner &runner, const char *stage, const Expected<void> &outcome) const {
  VOXC_TRY(options_.progress.check());
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
  const auto device = VOXC_TRY(devices_.open(cell.device->asked));
  runner.subject =
      VOXC_TRY(Subject::open(*volume, cell.kernelFormat,
                             {.device = device,
                              .threads = options_.threads,
                              .order = rayOrderFrom(cell.record.rays.order.value_or(kAutoOrder))}));
  return {};
}

Expected<void> Group::prepare(std::span<const BuiltCell> builtCells) {
  for (const BuiltCell &built : builtCells) {
    runners_.push_back({.cell = built.cell});
    Runner &runner = runners_.back();
    VOXC_TRY(recordFailure(runner, "compile", prepareOne(runner, built.volume.path)));
    options_.advance();
  }
  return {};
}

Expected<void> Group::traceRounds() {
  for (unsigned round = 0; round <= options_.rounds; ++round)
    for (Runner &runner : runners_) {
      if (runner.runs()) {
        Times *const times = round > 0 ? &runner.times : nullptr;
        const auto traced = runner.subject->trace(rays_.sampled.rays, times, options_.progress);
        VOXC_TRY(recordFailure(runner, "trace", traced));
      }
      options_.advance();
    }
  return {};
}

Expected<void> Group::examineOne(Runner &runner) const {
  Subject &subject = *runner.subject;
  runner.work.hits = static_cast<std::uint64_t>(std::ranges::count_if(subject.hits(), &Hit::isHit));
  const std::vector<Ray> &sample = rays_.sampled.sample;
  if (sample.empty())
    return {};
  if (rays_.oracle)
    runner.error = errorPart(
        compare(*rays_.oracle, sample, rays_.sampled.exact, rays_.sampled.sampleOf(subject.hits())));
  const auto steps = VOXC_TRY(subject.stepsPerRay(sample));
  const auto words = VOXC_TRY(subject.wordsPerRay(sample));
  runner.work.rays = sample.size();
  runner.work.stepsPerRay = steps;
  runner.work.wordsPerRay = words;
  return {};
}

Expected<void> Group::examine() {
  for (Runner &runner : runners_) {
    if (runner.runs())
      VOXC_TRY(recordFailure(runner, "trace", examineOne(runner)));
    options_.advance();
  }
  return {};
}

void Group::takePicture(const std::string &path, const Camera &camera) {
  const auto first = std::ranges::find_if(runners_, &Runner::runs);
  if (path.empty() || first == runners_.end())
    return;
  const std::vector<Ray> rays = cameraRays(camera);
  // A picture is no finding: a sweep without it is whole.
  if (first->subject->trace(rays, nullptr))
    static_cast<void>(writePicture(path, shade(rays, first->subject->hits(), camera.width, camera.height)));
}

bool Group::isSteady(const Cell &cell) const {
  const std::optional<Speed> &speed = speedOf(cell.record);
  if (!speed || speed->spread > options_.steady)
    return false;
  const std::optional<Speed> &before = cell.before ? speedOf(*cell.before) : speed;
  return !before || std::abs(speed->median - before->median) <= options_.steady * before->median;
}

void Group::record() const {
  for (const Runner &runner : runners_) {
    Record &record = runner.cell->record;
    record.failure = runner.failure;
    if (runner.failure)
      continue;
    const Subject &subject = *runner.subject;
    const Times &times = runner.times;
    const std::uint64_t count = rays_.sampled.rays.size();
    record.kernel = {subject.opened().kernelSeconds, subject.opened().uploadSeconds,
                     subject.firstDispatchSeconds()};
    record.speed = {options_.rounds,
                    speedOf(count, times.seconds),
                    speedOf(count, times.cpuSeconds),
                    speedOf(count, times.deviceSeconds),
                    {},
                    times.isBinned ? "binned" : "given"};
    record.work = runner.work;
    record.error = runner.error;
    record.speed.steady = isSteady(*runner.cell);
  }
}

} // namespace

std::size_t stepsOf(std::size_t cells, const MeasureOptions &options) {
  // Preparing, the round that warms, and examining are one each.
  return cells * (options.rounds + 3);
}

Expected<void> measure(std::span<const BuiltCell> builtCells, const GroupRays &rays,
                       const MeasureOptions &options, const std::string &picture, const Camera &camera) {
  Group group(rays, options);
  VOXC_TRY(group.prepare(builtCells));
  VOXC_TRY(group.traceRounds());
  VOXC_TRY(group.examine());
  group.record();
  group.takePicture(picture, camera);
  return {};
}

} // namespace voxc::tool::bench
