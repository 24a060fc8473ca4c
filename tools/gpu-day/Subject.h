// What is measured: a program that traces a set of rays, and how its steps are run.
#pragma once

#include "Program.h"
#include "common/Json.h"
#include "voxc/Trace/Ray.h"

#include <functional>
#include <optional>
#include <string>

namespace voxc::gpu {

/// The rays of a set on the device, and room for their hits.
struct RaysThere {
  std::string name;
  std::span<const Ray> rays;
  std::span<const Hit> exact;
  GpuBuffer buffer, hits;
};

/// Uploads a set. `padded`: room for so many rays more.
Expected<RaysThere> bringRays(const Gpu &gpu, const std::string &name, std::span<const Ray> rays,
                              std::span<const Hit> exact, std::uint64_t padded = 0);

/// Seconds of many runs of the same steps.
struct Times {
  std::vector<double> totals;        ///< Of all steps of a run, in rising order.
  std::vector<double> steps;         ///< The median of each step.
  std::optional<unsigned> megahertz; ///< The device's clock behind the last run.
  double median() const { return totals[totals.size() / 2]; }
};

/// Runs the steps again and again, first to warm the device and then to time them, for at least that long
/// each. Error: as of `Gpu::run`.
Expected<Times> timeSteps(const Gpu &gpu, std::span<const GpuStep> steps, double seconds);

/// Million rays a second, of so many rays: runs, median, min, max, and clock_mhz where that is known.
tool::Json speedJson(std::size_t rays, const Times &times);

/// The figures of a driver about a program, by its names for them.
tool::Json figuresJson(const Program &program);

} // namespace voxc::gpu
