// Looking for labels.
#include "Input/Dense/Labels.h"

#include "Input/Dense/DenseCells.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace voxc {

namespace {

/// Different values that may be labels whatever lies beside them: half of what 6 bits tell apart.
constexpr std::size_t kFew = 32;
/// Different values of the largest atlases of labels.
constexpr std::size_t kMost = 4096;
/// The share of equal neighbours from which on values are not measured ones, which have noise.
constexpr double kMostlyEqual = 0.75;
constexpr double kLeast = -32768;
constexpr double kGreatest = 65535;

class LabelCounter {
public:
  LabelCounter(double slope, double intercept) : slope_(slope), intercept_(intercept) {}

  void add(SampleLayout layout, const std::byte *samples, std::size_t count) {
    if (!arePossible_)
      return;
    values_.resize(count);
    loadSamples(layout, samples, count, values_.data());
    for (std::size_t i = 0; i < count && arePossible_; ++i) {
      values_[i] = slope_ * values_[i] + intercept_;
      addValue(values_[i]);
      if (i > 0 && values_[i] != 0 && values_[i - 1] != 0) {
        ++pairs_;
        equalPairs_ += values_[i] == values_[i - 1] ? 1 : 0;
      }
    }
  }

  std::optional<std::size_t> count() const {
    // Labels leave room for what has none, or are numbered without gaps; what was measured has a background.
    const bool areNumbered = least_ >= 0 && greatest_ <= 2 * double(different_);
    const bool areFew = different_ <= kFew && (hasZero_ || areNumbered);
    const bool areCoherent = double(equalPairs_) >= kMostlyEqual * double(pairs_);
    return arePossible_ && (areFew || areCoherent) ? std::optional(different_) : std::nullopt;
  }

private:
  void addValue(double value) {
    // NaN is not possible either.
    if (!(value >= kLeast && value <= kGreatest && value == std::floor(value))) {
      arePossible_ = false;
      return;
    }
    hasZero_ = hasZero_ || value == 0;
    least_ = std::min(least_, value);
    greatest_ = std::max(greatest_, value);
    auto &&isSeen = seen_[static_cast<std::size_t>(value - kLeast)];
    if (value != 0 && !isSeen) {
      isSeen = true;
      arePossible_ = ++different_ <= kMost;
    }
  }

  double slope_;
  double intercept_;
  bool arePossible_ = true;
  std::vector<bool> seen_ = std::vector<bool>(static_cast<std::size_t>(kGreatest - kLeast) + 1);
  std::size_t different_ = 0;
  bool hasZero_ = false;
  double least_ = 0;
  double greatest_ = 0;
  std::uint64_t pairs_ = 0;
  std::uint64_t equalPairs_ = 0;
  std::vector<double> values_;
};

} // namespace

Expected<std::optional<std::size_t>> countLabels(const DenseVolume &volume, const InputOptions &options) {
  LabelCounter counter(volume.slope, volume.intercept);
  const auto looked = forEachPiece(volume, options, [&](const std::byte *samples, std::size_t count) {
    counter.add(volume.layout, samples, count);
  });
  if (!looked)
    return looked.error();
  return counter.count();
}

} // namespace voxc
