// Learning from measurements, and choosing by them.
#include "voxc/Search/Acquisition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <ranges>

namespace voxc {
namespace {

/// Abscissas and weights of Gauss and Hermite for a normal distribution, of five points.
constexpr std::array<std::array<double, 2>, 5> kNormal = {{{-2.856970, 0.011257},
                                                           {-1.355626, 0.222076},
                                                           {0, 0.533333},
                                                           {1.355626, 0.222076},
                                                           {2.856970, 0.011257}}};

/// From how many formats at most, the newest, is told how others differ from the model: the time that takes
/// grows with their cube.
constexpr std::size_t kMostAlike = 256;

double meanOf(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(std::max<std::size_t>(values.size(), 1));
}

} // namespace

Acquisition::Acquisition(std::vector<PredictedFormat> formats, const SpeedModel &model,
                         const AcquisitionOptions &options)
    : formats_(std::move(formats)), prior_(model), model_(model), options_(options),
      states_(formats_.size(), State::Open), times_(formats_.size()) {}

SizeTime Acquisition::pointOf(std::size_t index, double nanoseconds) const {
  return {static_cast<double>(formats_[index].bytes()), nanoseconds};
}

void Acquisition::take(std::size_t index, std::span<const double> nanoseconds) {
  const PredictedFormat &format = formats_[index];
  for (std::size_t set = 0; set < nanoseconds.size(); ++set)
    samples_.push_back({speedTerms(format.costs[set], format.bytes()), nanoseconds[set]});
  if (states_[index] != State::Measured)
    measured_.push_back(index);
  states_[index] = State::Measured;
  times_[index] = meanOf(nanoseconds);
}

void Acquisition::drop(std::size_t index) { states_[index] = State::Dropped; }

void Acquisition::learn() {
  model_ = fitSpeedModel(samples_, prior_);
  for (PredictedFormat &format : formats_)
    predictAgain(format, model_);
  std::vector<SpeedCorrection::Sample> errors;
  for (const std::size_t i : std::views::reverse(measured_) | std::views::take(kMostAlike))
    if (formats_[i].candidate.composition)
      errors.push_back({*formats_[i].candidate.composition, std::log(times_[i] / formats_[i].time())});
  correction_ = SpeedCorrection(std::move(errors));
}

std::optional<double> Acquisition::timeOf(std::size_t index) const {
  return states_[index] == State::Measured ? std::optional(times_[index]) : std::nullopt;
}

Acquisition::Expectation Acquisition::expect(std::size_t index) const {
  const PredictedFormat &format = formats_[index];
  const SpeedCorrection::Estimate estimate =
      correction_.at(format.candidate.composition.value_or(Composition{}));
  return {format.time() * std::exp(estimate.error), estimate.deviation};
}

double Acquisition::expectedGain(const Frontier &frontier, std::size_t index,
                                 const Expectation &expected) const {
  double gain = 0;
  for (const auto &[abscissa, weight] : kNormal)
    gain += weight *
            frontier.gain(pointOf(index, expected.nanoseconds * std::exp(abscissa * expected.deviation)));
  return gain;
}

Frontier Acquisition::frontier() const {
  Frontier frontier(options_.mostBytes, options_.leastSpeed);
  for (std::size_t i = 0; i < formats_.size(); ++i)
    if (states_[i] == State::Measured)
      frontier.add(pointOf(i, times_[i]));
  return frontier;
}

std::vector<std::size_t> Acquisition::next(std::size_t count, double least) const {
  std::vector<std::size_t> open;
  std::vector<Expectation> expected(formats_.size());
  for (std::size_t i = 0; i < formats_.size(); ++i)
    if (isOpen(i)) {
      open.push_back(i);
      expected[i] = expect(i);
    }
  Frontier believed = frontier();
  std::vector<std::size_t> chosen;
  while (chosen.size() < count && !open.empty()) {
    std::vector<double> gains(open.size());
    std::ranges::transform(open, gains.begin(),
                           [&](std::size_t i) { return expectedGain(believed, i, expected[i]); });
    const auto best = std::ranges::max_element(gains);
    if (least >= 0 && *best <= least * believed.area())
      break;
    const auto at = open.begin() + (best - gains.begin());
    believed.add(pointOf(*at, expected[*at].nanoseconds));
    chosen.push_back(*at);
    open.erase(at);
  }
  return chosen;
}

} // namespace voxc
