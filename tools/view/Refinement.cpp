// The steps of a picture.
#include "view/Refinement.h"

#include <algorithm>
#include <iterator>

namespace voxc::view {
namespace {

/// From fine to coarse.
constexpr int kDivisors[] = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32};

/// With which one begins that knows nothing.
constexpr int kUnknownDivisor = 8;

/// Each step takes at least so many times as long as the one before.
constexpr int kFiner = 2;
constexpr unsigned kMoreSamples = 4;

/// The finest divisor that is at least `divisor`.
int atLeast(int divisor) {
  const int *const found = std::ranges::lower_bound(kDivisors, divisor);
  return found == std::end(kDivisors) ? kDivisors[std::size(kDivisors) - 1] : *found;
}

} // namespace

void Refinement::forgetTimes() {
  secondsOfAll_.reset();
  restart();
}

int Refinement::firstDivisor() const {
  if (!secondsOfAll_)
    return kUnknownDivisor;
  // What a step takes beside its pixels is taken for theirs, so that finer ones are dared a little at a time.
  const int *const found = std::ranges::find_if(
      kDivisors, [this](int divisor) { return *secondsOfAll_ / (divisor * divisor) <= budget_; });
  return found == std::end(kDivisors) ? kDivisors[std::size(kDivisors) - 1] : *found;
}

std::optional<RefinementStep> Refinement::next() const {
  if (!last_)
    return RefinementStep{firstDivisor(), 1};
  if (last_->divisor > 1)
    return RefinementStep{last_->divisor <= kFiner ? 1 : atLeast((last_->divisor + kFiner - 1) / kFiner), 1};
  if (last_->samples < mostSamples_)
    return RefinementStep{1, std::min(last_->samples * kMoreSamples, mostSamples_)};
  return std::nullopt;
}

void Refinement::took(const RefinementStep &step, double seconds) {
  if (step.samples == 1)
    secondsOfAll_ = seconds * step.divisor * step.divisor;
}

} // namespace voxc::view
