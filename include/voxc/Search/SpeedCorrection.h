// What measurements show of a speed model's errors: formats that are alike are wrong alike.
#pragma once

#include "voxc/Search/Composition.h"

#include <span>
#include <vector>

namespace voxc {

/// A Gaussian process over compositions (Rasmussen and Williams, "Gaussian Processes for Machine Learning",
/// algorithm 2.1). The logarithms of measured times over predicted ones are a part that all have in common,
/// and a part that is the more alike the fewer heights two compositions differ in. How large and how far it
/// reaches is chosen by the likelihood of the samples.
class SpeedCorrection {
public:
  struct Sample {
    Composition composition;
    double error; ///< ln(measured / predicted).
  };

  /// Without samples nothing is corrected, and the deviation is the model's default one.
  explicit SpeedCorrection(std::vector<Sample> samples = {});

  struct Estimate {
    double error = 0;     ///< That is expected, to be added to the logarithm of the predicted time.
    double deviation = 0; ///< Its standard deviation.
  };
  Estimate at(const Composition &composition) const;

private:
  struct Kernel {
    double deviation; ///< Of the part that differs.
    double reach;     ///< In differences.
  };

  double covariance(const Composition &a, const Composition &b) const;
  double tryKernel(const Kernel &kernel);
  void solve(std::vector<double> &values) const;

  std::vector<Sample> samples_;
  Kernel kernel_;
  std::vector<double> factor_;  ///< The lower triangle of Cholesky's factor, row by row.
  std::vector<double> weights_; ///< Of the samples' covariances.
};

} // namespace voxc
