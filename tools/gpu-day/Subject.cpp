// Rays on a device, and times of programs.
#include "Subject.h"

#include "Clock.h"

#include <algorithm>

namespace voxc::gpu {
namespace {

constexpr int kFewestRuns = 5;

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
  auto buffer = gpu.makeBuffer(room);
  if (!buffer)
    return buffer.error();
  auto hits = gpu.makeBuffer(room);
  if (!hits)
    return hits.error();
  if (auto uploaded = gpu.upload(*buffer, std::as_bytes(rays)); !uploaded)
    return uploaded.error();
  return RaysThere{name, rays, exact, std::move(*buffer), std::move(*hits)};
}

Expected<Times> timeSteps(const Gpu &gpu, std::span<const GpuStep> steps, double seconds) {
  Times times;
  std::vector<std::vector<double>> ofStep(steps.size());
  double warmed = 0, timed = 0;
  while (timed < seconds || static_cast<int>(times.totals.size()) < kFewestRuns) {
    const auto run = gpu.run(steps);
    if (!run)
      return run.error();
    const double total = sum(*run);
    // The first runs compile, fill caches, and raise clocks.
    if (warmed < seconds / 2) {
      warmed += total;
      continue;
    }
    timed += total;
    times.totals.push_back(total);
    for (std::size_t i = 0; i < steps.size(); ++i)
      ofStep[i].push_back((*run)[i]);
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
