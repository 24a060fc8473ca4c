// From what rays cost to how fast they are.
#include "voxc/Search/SpeedModel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace voxc {
namespace {

constexpr double kMebibyte = 1 << 20;
/// log2 of the MiB that the caches of a core hold.
constexpr double kNear = 2;
constexpr int kSweeps = 4000;
/// How strongly a model is drawn to its prior: as by so many samples.
constexpr double kPriorWeight = 0.013;
/// Nanoseconds: a part that a prior does not have is drawn to 0 as if it had so much of it.
constexpr double kNoShare = 0.5;

/// In the order of `SpeedTerm`, fitted by scripts/fit-speeds.py; docs/search.md tells from what, and how
/// well. No L1 distances were among that, so that the weight of a march is a guess; no candidate of
/// `candidatesFor` has any.
constexpr SpeedModel kCpu{{19, 25, 2.6, 0, 0.80, 0.34, 1.1, 0.27, 1.6, 2, 25, 0, 2.5, 0.38, 0.80}};
constexpr SpeedModel kLavapipe{{26, 55, 9.7, 32, 5.5, 0.97, 7.4, 1.6, 4.9, 5, 0, 14, 2.6, 0.10, 4.5}};

} // namespace

SpeedTerms speedTerms(const RayCost &cost, std::uint64_t bytes) {
  const double far = std::log2(1 + static_cast<double>(bytes) / kMebibyte);
  return {1,
          cost.binned,
          cost.levels,
          cost.colours,
          cost.turns,
          cost.words,
          cost.probes,
          cost.packetLayers,
          cost.packetTrees,
          cost.marches,
          cost.switches,
          cost.packetSwitches,
          cost.lines,
          cost.waits * far,
          cost.lines * std::max(far - kNear, 0.0)};
}

double SpeedModel::predict(const SpeedTerms &terms) const {
  return std::inner_product(terms.begin(), terms.end(), nanoseconds.begin(), 0.0);
}

SpeedModel fitSpeedModel(std::span<const SpeedSample> samples, const SpeedModel &prior) {
  // Relative errors: each sample is divided by its time, so that 1 is to be told.
  const std::size_t kTerms = kSpeedTerms;
  std::array<SpeedTerms, kSpeedTerms> products{};
  SpeedTerms targets{};
  for (const SpeedSample &sample : samples)
    for (std::size_t i = 0; i < kTerms; ++i) {
      const double a = sample.terms[i] / sample.nanoseconds;
      targets[i] += a;
      for (std::size_t j = 0; j < kTerms; ++j)
        products[i][j] += a * sample.terms[j] / sample.nanoseconds;
    }
  SpeedModel model = prior;
  const bool isKnown = prior.nanoseconds != SpeedTerms{};
  for (std::size_t i = 0; i < kTerms && isKnown; ++i) {
    // A term's own share of the prior is let go the more easily the larger it is.
    const double share = prior.nanoseconds[i] > 0 ? prior.nanoseconds[i] : kNoShare;
    const double scale = kPriorWeight / (share * share);
    products[i][i] += scale;
    targets[i] += scale * prior.nanoseconds[i];
  }
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (std::size_t i = 0; i < kTerms; ++i) {
      if (products[i][i] <= 0)
        continue;
      double rest = targets[i];
      for (std::size_t j = 0; j < kTerms; ++j)
        if (j != i)
          rest -= products[i][j] * model.nanoseconds[j];
      model.nanoseconds[i] = std::max(rest / products[i][i], 0.0);
    }
  return model;
}

const SpeedModel &defaultSpeedModel(std::string_view device) { return device == "cpu" ? kCpu : kLavapipe; }

} // namespace voxc
