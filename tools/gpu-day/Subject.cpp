// Rays on a device, and times of programs.
#include "Subject.h"

#include "Clock.h"

#include <algorithm>

namespace voxc::gpu {
namespace {

constexpr int kFewestRuns = 5;
constexpr double kLongestWarmUp = 1; // Seconds.
constexpr double kNoFaster = 0.98;

/// Whether a device has its highest clock: runs have not become faster for so long. A clock that has gone
/// down while the device waited takes a tenth of a second to rise.
class WarmUp {
public:
  explicit WarmUp(double seconds) : seconds_(seconds) {}

  /// Counts a run in; true if that was the last.
  bool isOver(double run) {
    all_ += run;
    steady_ = run < kNoFaster * least_ ? 0 : steady_ + run;
    least_ = steady_ == 0 ? run : least_;
    return steady_ >= seconds_ || all_ >= kLongestWarmUp;
  }

private:
  double seconds_, all_ = 0, steady_ = 0, least_ = 1e30;
};

double sum(const std::vector<double> &seconds) {
  double all = 0;
  for (const double of : seconds)
    all += of;
  return all;
}

} // namespace

Expected<RaysThere> bringRays(const Gpu &gpu, const std::string &name, std::span<const Ray> rays,
                              std::span<const Hit> exact, std::uint64_t padded) {
  const std::uint64_t room = (rays.size() + padded) * sizeof(Ray);
  auto buffer = VOXC_TRY(gpu.makeBuffer(room));
  auto hits = VOXC_TRY(gpu.makeBuffer(room));
  VOXC_TRY(gpu.upload(buffer, std::as_bytes(rays)));
  return RaysThere{name, rays, exact, std::move(buffer), std::move(hits)};
}

Expected<Times> timeSteps(const Gpu &gpu, std::span<const GpuStep> steps, double seconds) {
  Times times;
  std::vector<std::vector<double>> ofStep(steps.size());
  // The first runs compile, fill caches, and raise clocks.
  WarmUp warmUp(seconds);
  for (bool isWarm = false; !isWarm;) {
    const auto run = VOXC_TRY(gpu.run(steps));
    isWarm = warmUp.isOver(sum(run));
  }
  double timed = 0;
  while (timed < seconds || static_cast<int>(times.totals.size()) < kFewestRuns) {
    const auto run = VOXC_TRY(gpu.run(steps));
    const double total = sum(run);
    timed += total;
    times.totals.push_back(total);
    for (std::size_t i = 0; i < steps.size(); ++i)
      ofStep[i].push_back(run[i]);
  }
  times.megahertz = clockMegahertz();
  std::ranges::sort(times.totals);
  for (std::vector<double> &all : ofStep) {
    std::ranges::sort(all);
    times.steps.push_back(all[all.size() / 2]);
  }
  return times;
}

tool::Json speedJson(std::size_t rays, const Times &times) {
  const auto speed = [&](double seconds) { return static_cast<double>(rays) / seconds / 1e6; };
  tool::Json figures{{"runs", times.totals.size()},
                     {"median", speed(times.median())},
                     {"min", speed(times.totals.back())},
                     {"max", speed(times.totals.front())}};
  if (times.megahertz)
    figures["clock_mhz"] = *times.megahertz;
  return figures;
}

tool::Json figuresJson(const Program &program) {
  tool::Json figures = tool::Json::object();
  for (const ProgramFigure &figure : program.figures())
    figures[figure.name] = figure.value;
  return figures;
}

} // namespace voxc::gpu
