// Clocks and counters around calls.
#include "Measure.h"

#include "Allocations.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <sys/resource.h>

namespace voxc::cliffs {
namespace {

/// A measurement takes as many calls as fill this, or one.
constexpr double kLeastNanoseconds = 4e6;
constexpr int kMeasurements = 3;
/// Where one call takes so long, noise is small beside it.
constexpr double kLongNanoseconds = 5e8;

double cpuNanoseconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

std::uint64_t faultsSoFar() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_minflt);
}

/// Nanoseconds of a call, over so many.
Expected<double> timeOf(Subject &subject, int calls) {
  const double begin = cpuNanoseconds();
  for (int call = 0; call < calls; ++call)
    if (auto traced = subject.trace(); !traced)
      return traced.error();
  return (cpuNanoseconds() - begin) / calls;
}

} // namespace

Expected<void> measureAgain(Subject &subject, Cost &cost) {
  const int calls =
      std::clamp(static_cast<int>(kLeastNanoseconds / std::max(cost.nanoseconds, 1.0)), 1, 10000);
  const int measurements = cost.nanoseconds > kLongNanoseconds ? 1 : kMeasurements;
  for (int i = 0; i < measurements; ++i) {
    const auto time = timeOf(subject, calls);
    if (!time)
      return time.error();
    cost.nanoseconds = std::min(cost.nanoseconds, *time);
  }
  return {};
}

Expected<std::uint64_t> countCall(Subject &subject) {
  const std::uint64_t before = allocationsSoFar();
  if (auto traced = subject.trace(); !traced)
    return traced.error();
  return allocationsSoFar() - before;
}

Expected<Cost> measure(Subject &subject) {
  const auto first = timeOf(subject, 1);
  if (!first)
    return first.error();
  Cost cost{.firstNanoseconds = *first};
  const std::uint64_t allocations = allocationsSoFar(), faults = faultsSoFar();
  const auto second = timeOf(subject, 1);
  if (!second)
    return second.error();
  cost.nanoseconds = *second;
  cost.allocations = allocationsSoFar() - allocations;
  cost.faults = faultsSoFar() - faults;
  if (auto done = measureAgain(subject, cost); !done)
    return done.error();
  return cost;
}

} // namespace voxc::cliffs
