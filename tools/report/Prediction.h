// How well what a search foretold came true.
#pragma once

#include "report/Catalogue.h"

#include <optional>
#include <vector>

namespace voxc::report {

/// A speed that was foretold and measured, both in what the device counts.
struct Prediction {
  const Entry *entry = nullptr;
  double foretold = 0, measured = 0;

  /// By what share of the measured speed the other one is off.
  double error() const;
};

/// Those of a stage, in the order of its entries.
std::vector<Prediction> predictionsOf(const Catalogue &catalogue, const Stage &stage);

/// The median of the errors; 0 without any.
double medianError(const std::vector<Prediction> &predictions);

/// Spearman's rank correlation, ties sharing their mean rank: 1 if the order came true. None if either side
/// has fewer than two different values.
std::optional<double> rankCorrelation(const std::vector<Prediction> &predictions);

/// Sizes that were foretold and built.
struct WordPredictions {
  std::size_t all = 0, exact = 0;
  std::uint64_t worst = 0; ///< The largest difference in words.
};
WordPredictions wordPredictionsOf(const Catalogue &catalogue, const Stage &stage);

} // namespace voxc::report
