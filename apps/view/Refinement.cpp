// The steps of a picture.
#include "view/Refinement.h"

#include <algorithm>
#include <cmath>

namespace voxc::view {
namespace {

/// The coarsest divisor, and the one with which one begins that knows nothing.
constexpr int kCoarsest = 32, kUnknown = 8;

/// Each step has so many times the pixels a side as the one before, or so many times the samples.
constexpr int kFiner = 2;
constexpr unsigned kMoreSamples = 4;

} // namespace

void Refinement::forgetTimes() {
  secondsOfAll_.reset();
  restart();
}

int Refinement::firstDivisor() const {
  if (!secondsOfAll_)
    return kUnknown;
  // What a draft takes beside its pixels is taken for theirs, so that finer ones are dared a little at a
  // time.
  const double divisor = std::ceil(std::sqrt(*secondsOfAll_ / budget_));
  return int(std::clamp(divisor, 1.0, double(kCoarsest)));
}

std::optional<RefinementStep> Refinement::next() const {
  if (!last_)
    return RefinementStep{firstDivisor(), 1, true};
  if (last_->divisor > 1 || last_->isDraft)
    return RefinementStep{(last_->divisor + kFiner - 1) / kFiner, 1, false};
  if (last_->samples < mostSamples_)
    return RefinementStep{1, std::min(last_->samples * kMoreSamples, mostSamples_), false};
  return std::nullopt;
}

void Refinement::took(const RefinementStep &step, double seconds) {
  if (step.isDraft)
    secondsOfAll_ = seconds * step.divisor * step.divisor;
}

} // namespace voxc::view
