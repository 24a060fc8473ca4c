// Which format to measure next: the one by which the frontier of all that was measured is expected to grow
// most.
#pragma once

#include "voxc/Search/FormatPredictor.h"
#include "voxc/Search/Frontier.h"
#include "voxc/Search/SpeedCorrection.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace voxc {

struct AcquisitionOptions {
  double mostBytes = 0;  ///< Sizes above are of no use.
  double leastSpeed = 0; ///< Million rays a second; those below are of no use.
};

/// Formats on their way from a predicted speed to a measured one. It learns from those that are measured: the
/// model of the device is fitted anew, and what it leaves is estimated from formats that are alike
/// (`SpeedCorrection`).
class Acquisition {
public:
  /// All formats have the same sets of rays. `model` is what is known of the device before.
  Acquisition(std::vector<PredictedFormat> formats, const SpeedModel &model,
              const AcquisitionOptions &options);

  const std::vector<PredictedFormat> &formats() const { return formats_; }

  /// Takes in what a format was measured to take: nanoseconds a ray of each set.
  void take(std::size_t index, std::span<const double> nanoseconds);
  /// The format cannot be measured.
  void drop(std::size_t index);
  bool isOpen(std::size_t index) const { return states_[index] == State::Open; }
  /// Learns from all that was taken in: what is expected, the model, and so what is next.
  void learn();

  /// The mean of the sets as measured; none if it was not.
  std::optional<double> timeOf(std::size_t index) const;
  /// The mean as it is expected now, and the standard deviation of its logarithm.
  struct Expectation {
    double nanoseconds = 0;
    double deviation = 0;
  };
  Expectation expect(std::size_t index) const;

  /// At most `count` formats that are still to be measured, the most promising first, each under the
  /// expectation that those before it are as they are expected to be. None whose expected gain is less than
  /// `least` of the frontier's area; below 0: all.
  std::vector<std::size_t> next(std::size_t count, double least) const;

  /// Of all that was measured.
  Frontier frontier() const;

  /// The model as fitted by what was measured.
  const SpeedModel &model() const { return model_; }

private:
  enum class State { Open, Measured, Dropped };

  SizeTime pointOf(std::size_t index, double nanoseconds) const;
  double expectedGain(const Frontier &frontier, std::size_t index, const Expectation &expected) const;

  std::vector<PredictedFormat> formats_;
  SpeedModel prior_, model_;
  AcquisitionOptions options_;
  std::vector<State> states_;
  std::vector<double> times_;         ///< Of each format that was measured.
  std::vector<std::size_t> measured_; ///< In the order in which they were taken in.
  std::vector<SpeedSample> samples_;
  SpeedCorrection correction_;
};

} // namespace voxc
