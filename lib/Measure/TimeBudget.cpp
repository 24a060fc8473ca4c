// Asking a clock.
#include "voxc/Measure/TimeBudget.h"

#include <chrono>
#include <utility>

namespace voxc::measure {
namespace {

double secondsOfMachine() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

TimeBudget::TimeBudget(double seconds, std::function<double()> clock)
    : clock_(clock ? std::move(clock) : secondsOfMachine), begin_(clock_()), seconds_(seconds) {}

TimeBudget TimeBudget::endingAfter(double seconds) const {
  TimeBudget other = *this;
  other.seconds_ = seconds;
  return other;
}

Progress TimeBudget::within(const Progress &progress) const {
  Progress bounded = progress;
  bounded.ask = [budget = *this, before = progress.ask] { return budget.isOver() || (before && before()); };
  return bounded;
}

} // namespace voxc::measure
