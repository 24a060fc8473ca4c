// A small Gaussian process.
#include "voxc/Search/SpeedCorrection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace voxc {
namespace {

/// Of what all formats have in common: another processor, or a busy one.
constexpr double kCommon = 0.3;
/// Of a measurement that is taken again.
constexpr double kNoise = 0.03;
/// What is tried. With less, a search that has measured formats of one kind alone believes it knows the
/// others.
constexpr double kDeviations[] = {0.2, 0.3};
constexpr double kReaches[] = {2, 5, 12};
/// Without samples: what the model leaves on scenes that it was not fitted on.
constexpr std::size_t kDefaultDeviation = 0, kDefaultReach = 1;

std::size_t rowAt(std::size_t row) { return row * (row + 1) / 2; }

} // namespace

SpeedCorrection::SpeedCorrection(std::vector<Sample> samples)
    : samples_(std::move(samples)), kernel_{kDeviations[kDefaultDeviation], kReaches[kDefaultReach]} {
  if (samples_.empty())
    return;
  Kernel best = kernel_;
  double most = -std::numeric_limits<double>::infinity();
  for (const double deviation : kDeviations)
    for (const double reach : kReaches)
      if (const double likelihood = tryKernel({deviation, reach}); likelihood > most) {
        most = likelihood;
        best = kernel_;
      }
  tryKernel(best);
}

double SpeedCorrection::covariance(const Composition &a, const Composition &b) const {
  return kCommon * kCommon +
         kernel_.deviation * kernel_.deviation * std::exp(-differences(a, b) / kernel_.reach);
}

/// Factors the covariances of the samples. Returns the logarithm of their likelihood, but for a constant.
double SpeedCorrection::tryKernel(const Kernel &kernel) {
  kernel_ = kernel;
  const std::size_t count = samples_.size();
  factor_.assign(rowAt(count), 0);
  double logDeterminant = 0;
  for (std::size_t row = 0; row < count; ++row)
    for (std::size_t column = 0; column <= row; ++column) {
      double rest = covariance(samples_[row].composition, samples_[column].composition) +
                    (row == column ? kNoise * kNoise : 0);
      for (std::size_t k = 0; k < column; ++k)
        rest -= factor_[rowAt(row) + k] * factor_[rowAt(column) + k];
      factor_[rowAt(row) + column] = row == column ? std::sqrt(rest) : rest / factor_[rowAt(column) + column];
      logDeterminant += row == column ? std::log(std::sqrt(rest)) : 0;
    }
  weights_.resize(count);
  std::ranges::transform(samples_, weights_.begin(), &Sample::error);
  solve(weights_);
  const double square = std::inner_product(weights_.begin(), weights_.end(), weights_.begin(), 0.0);
  for (std::size_t row = count; row-- > 0;) { // And by the factor's transpose.
    for (std::size_t below = row + 1; below < count; ++below)
      weights_[row] -= factor_[rowAt(below) + row] * weights_[below];
    weights_[row] /= factor_[rowAt(row) + row];
  }
  return -0.5 * square - logDeterminant;
}

/// Divides by the factor.
void SpeedCorrection::solve(std::vector<double> &values) const {
  for (std::size_t row = 0; row < values.size(); ++row) {
    for (std::size_t k = 0; k < row; ++k)
      values[row] -= factor_[rowAt(row) + k] * values[k];
    values[row] /= factor_[rowAt(row) + row];
  }
}

SpeedCorrection::Estimate SpeedCorrection::at(const Composition &composition) const {
  std::vector<double> near(samples_.size());
  std::ranges::transform(samples_, near.begin(),
                         [&](const Sample &sample) { return covariance(sample.composition, composition); });
  const double error = std::inner_product(near.begin(), near.end(), weights_.begin(), 0.0);
  solve(near);
  const double known = std::inner_product(near.begin(), near.end(), near.begin(), 0.0);
  return {error, std::sqrt(std::max(covariance(composition, composition) - known, kNoise * kNoise))};
}

} // namespace voxc
