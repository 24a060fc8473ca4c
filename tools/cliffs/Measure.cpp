// Clocks and counters around calls.
#include "Measure.h"

#include "Allocations.h"

#include <algorithm>
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
  double passed = 0;
  for (int call = 0; call < calls; ++call)
    passed += VOXC_TRY(subject.trace());
  return (subject.isOnProcessor() ? cpuNanoseconds() - begin : passed) / calls;
}

} // namespace

Expected<void> measureAgain(Subject &subject, Cost &cost) {
  const int calls =
      std::clamp(static_cast<int>(kLeastNanoseconds / std::max(cost.nanoseconds, 1.0)), 1, 10000);
  const int measurements = cost.nanoseconds > kLongNanoseconds ? 1 : kMeasurements;
  for (int i = 0; i < measurements; ++i) {
    const auto time = VOXC_TRY(timeOf(subject, calls));
    cost.nanoseconds = std::min(cost.nanoseconds, time);
  }
  return {};
}

Expected<std::uint64_t> countCall(Subject &subject) {
  const std::uint64_t before = allocationsSoFar();
  VOXC_TRY(subject.trace());
  return allocationsSoFar() - before;
}

Expected<Cost> measure(Subject &subject) {
  const auto first = VOXC_TRY(timeOf(subject, 1));
  Cost cost{.firstNanoseconds = first};
  const std::uint64_t allocations = allocationsSoFar(), faults = faultsSoFar();
  cost.nanoseconds = VOXC_TRY(timeOf(subject, 1));
  cost.allocations = allocationsSoFar() - allocations;
  cost.faults = faultsSoFar() - faults;
  VOXC_TRY(measureAgain(subject, cost));
  return cost;
}

} // namespace voxc::cliffs
