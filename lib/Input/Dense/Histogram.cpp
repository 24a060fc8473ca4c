// Histograms of dense volumes.
#include "Input/Dense/Histogram.h"

#include "Input/Dense/DenseCells.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace voxc {

std::uint64_t Histogram::total() const {
  return std::accumulate(counts.begin(), counts.end(), zeros + noNumbers);
}

double Histogram::width() const {
  // The range itself may be beyond all numbers.
  return range.high / double(counts.size()) - range.low / double(counts.size());
}

double Histogram::shareFrom(double threshold) const {
  std::uint64_t above = 0;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (range.low + (double(i) + 0.5) * width() >= threshold)
      above += counts[i];
  return total() == 0 ? 0 : double(above) / double(total());
}

double Histogram::threshold() const {
  // The zeros lie in the part of the range where 0 is.
  std::array<double, 256> weights{};
  std::ranges::copy(counts, weights.begin());
  const double zeroPart = width() > 0 ? (0 - range.low) / width() : 0;
  weights[std::size_t(std::clamp(zeroPart, 0.0, 255.0))] += double(zeros);
  double all = 0, sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    all += weights[i];
    sum += weights[i] * double(i);
  }
  double below = 0, sumBelow = 0, best = -1;
  std::size_t chosen = 0;
  for (std::size_t i = 0; i + 1 < weights.size(); ++i) {
    below += weights[i];
    sumBelow += weights[i] * double(i);
    if (below == 0 || below == all)
      continue;
    const double apart = sumBelow / below - (sum - sumBelow) / (all - below);
    const double variance = below * (all - below) * apart * apart;
    if (variance > best) {
      best = variance;
      chosen = i;
    }
  }
  return range.low + double(chosen + 1) * width();
}

Expected<Histogram> histogramOf(const DenseVolume &volume, const SampleMap &map, const SampleRange &range,
                                const InputOptions &options) {
  Histogram histogram{.range = range};
  // As colours are chosen by value, so are parts of the range: the word of part i is i + 1, that of 0 is 0.
  SampleMap parts = map;
  parts.threshold.reset();
  parts.window = range;
  for (std::size_t i = 0; i < parts.colours.size(); ++i)
    parts.colours[i] = std::uint32_t(i + 1);
  std::vector<double> stored;
  const auto counted = forEachPiece(volume, options, [&](const std::byte *samples, std::size_t some) {
    stored.resize(some);
    loadSamples(volume.layout, samples, some, stored.data());
    for (const double sample : stored) {
      const double value = map.value(sample);
      const std::uint32_t word = parts.wordOf(value);
      isNothing(value) ? ++histogram.noNumbers : word == 0 ? ++histogram.zeros : ++histogram.counts[word - 1];
    }
  });
  if (!counted)
    return counted.error();
  return histogram;
}

} // namespace voxc
