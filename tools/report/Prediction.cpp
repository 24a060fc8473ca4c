// Comparing predictions with measurements.
#include "report/Prediction.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace voxc::report {
namespace {

/// The rank of each value from 1 up; equal values have the mean of their ranks.
std::vector<double> ranksOf(const std::vector<double> &values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
  std::vector<double> ranks(values.size());
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    while (end < order.size() && values[order[end]] == values[order[begin]])
      ++end;
    for (std::size_t i = begin; i < end; ++i)
      ranks[order[i]] = double(begin + 1 + end) / 2;
    begin = end;
  }
  return ranks;
}

/// Pearson's correlation.
std::optional<double> correlation(const std::vector<double> &a, const std::vector<double> &b) {
  const double count = double(a.size());
  const double meanA = std::accumulate(a.begin(), a.end(), 0.0) / count;
  const double meanB = std::accumulate(b.begin(), b.end(), 0.0) / count;
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - meanA) * (b[i] - meanB);
    aa += (a[i] - meanA) * (a[i] - meanA);
    bb += (b[i] - meanB) * (b[i] - meanB);
  }
  return aa > 0 && bb > 0 ? std::optional(ab / std::sqrt(aa * bb)) : std::nullopt;
}

} // namespace

double Prediction::error() const { return std::abs(foretold - measured) / measured; }

std::vector<Prediction> predictionsOf(const Catalogue &catalogue, const Stage &stage) {
  constexpr double kMost = 1e12; // What is computed of it stays finite.
  std::vector<Prediction> predictions;
  for (const std::size_t i : stage.entries) {
    const Entry &entry = catalogue.entries[i];
    if (!entry.hasPoint() || !entry.cell->predicted)
      continue;
    const double foretold = entry.cell->predicted->mraysPerS.value_or(0);
    if (foretold > 0 && foretold < kMost)
      predictions.push_back({&entry, foretold, entry.speed->median});
  }
  return predictions;
}

double medianError(const std::vector<Prediction> &predictions) {
  std::vector<double> errors;
  errors.reserve(predictions.size());
  for (const Prediction &prediction : predictions)
    errors.push_back(prediction.error());
  std::ranges::sort(errors);
  const std::size_t middle = errors.size() / 2;
  if (errors.empty())
    return 0;
  return errors.size() % 2 == 1 ? errors[middle] : (errors[middle - 1] + errors[middle]) / 2;
}

std::optional<double> rankCorrelation(const std::vector<Prediction> &predictions) {
  std::vector<double> foretold, measured;
  for (const Prediction &prediction : predictions) {
    foretold.push_back(prediction.foretold);
    measured.push_back(prediction.measured);
  }
  return predictions.empty() ? std::nullopt : correlation(ranksOf(foretold), ranksOf(measured));
}

WordPredictions wordPredictionsOf(const Catalogue &catalogue, const Stage &stage) {
  WordPredictions found;
  for (const std::size_t i : stage.entries) {
    const Cell &cell = *catalogue.entries[i].cell;
    const tool::bench::Count foretold = cell.predicted ? cell.predicted->words : tool::bench::Count();
    if (!foretold || !cell.volume.words)
      continue;
    const auto [least, most] = std::minmax(*foretold, *cell.volume.words);
    ++found.all;
    found.exact += least == most;
    found.worst = std::max(found.worst, most - least);
  }
  return found;
}

} // namespace voxc::report
