// Facts of dense volumes.
#include "Input/Dense/DenseFacts.h"

#include "Input/Openers/InputText.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace voxc {

namespace {

constexpr std::size_t kRows = 16; ///< Of the histogram as it is told.

InputFact samplesFact(const DenseVolume &volume) {
  std::string text = toText(volume.layout);
  if (volume.slope != 1 || volume.intercept != 0)
    text +=
        ", each " + toText(volume.slope) + " times what is stored, and " + toText(volume.intercept) + " more";
  return {"samples", std::move(text), {}};
}

/// The length of the step from one sample to the next along each axis.
InputFact spacingFact(const Transform &sampleToModel) {
  std::array<double, 3> lengths;
  for (int axis = 0; axis < 3; ++axis)
    lengths[static_cast<std::size_t>(axis)] = glm::length(sampleToModel[axis]);
  return {"spacing", byThree(lengths), {lengths.begin(), lengths.end()}};
}

InputFact rangeFact(const SampleRange &range) {
  return {"range", toText(range.low) + " to " + toText(range.high), {range.low, range.high}};
}

/// How many samples are something.
InputFact countFact(std::string name, std::uint64_t count, const Histogram &histogram) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%llu, %.1f %%", static_cast<unsigned long long>(count),
                100 * double(count) / double(std::max<std::uint64_t>(histogram.total(), 1)));
  return {std::move(name), text.data(), {double(count)}};
}

/// A row for each part of the range, with a bar as long as its share.
InputFact histogramFact(const Histogram &histogram) {
  const std::size_t countsOfRow = histogram.counts.size() / kRows;
  const double width = histogram.width() * double(countsOfRow);
  std::array<std::uint64_t, kRows> counts{};
  for (std::size_t i = 0; i < histogram.counts.size(); ++i)
    counts[i * kRows / histogram.counts.size()] += histogram.counts[i];
  InputFact fact{"histogram", "", {}};
  const double total = double(std::max<std::uint64_t>(histogram.total(), 1));
  for (std::size_t i = 0; i < kRows; ++i) {
    const double share = double(counts[i]) / total;
    std::array<char, 64> row;
    std::snprintf(row.data(), row.size(), "from %-12.6g %5.1f %%", histogram.range.low + double(i) * width,
                  100 * share);
    const std::string bar(static_cast<std::size_t>(std::lround(40 * share)), '#');
    fact.text += (i == 0 ? "" : "\n") + std::string(row.data()) + (bar.empty() ? "" : " " + bar);
    fact.numbers.push_back(double(counts[i]));
  }
  return fact;
}

} // namespace

std::vector<InputFact> factsOf(const DenseVolume &volume, const Histogram &histogram) {
  std::vector<InputFact> facts{samplesFact(volume), sizeFact("size", volume.extent),
                               spacingFact(volume.sampleToModel), rangeFact(histogram.range),
                               countFact("zeros", histogram.zeros, histogram)};
  if (histogram.noNumbers > 0)
    facts.push_back(countFact("no numbers", histogram.noNumbers, histogram));
  if (histogram.range.low < histogram.range.high)
    facts.push_back(histogramFact(histogram));
  return facts;
}

std::vector<InputFact> factsOf(const DenseVolume &volume) {
  return {{"samples",
           "colours of " + std::to_string(volume.channels) + " channels, " + toText(volume.layout),
           {}},
          sizeFact("size", volume.extent),
          spacingFact(volume.sampleToModel)};
}

} // namespace voxc
