// Which format a scene asks for.
#include "voxc/Search/Suggest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace voxc {
namespace {

/// Of the logarithm of bytes beside that of time.
constexpr double kSizeWeight = 0.5;

double regret(const SizeTime &point, Wish::Objective objective) {
  const double time = std::log2(point.nanoseconds);
  const double bytes = std::log2(point.bytes);
  // What does not matter still decides between equals.
  constexpr double kHint = 1e-6;
  switch (objective) {
  case Wish::Objective::Fastest:
    return time + kHint * bytes;
  case Wish::Objective::Smallest:
    return bytes + kHint * time;
  case Wish::Objective::Balanced:
    break;
  }
  return time + kSizeWeight * bytes;
}

} // namespace

Expected<std::vector<PredictedFormat>>
predictFormats(const ModelledScene &scene, std::vector<Candidate> candidates, const std::vector<RaySet> &rays,
               const SpeedModel &model, const Wish &wish, const Progress &progress) {
  FormatPredictor predictor(scene);
  std::vector<PredictedFormat> rated;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    VOXC_TRY(progress.check());
    progress.at("rate", static_cast<double>(i) / static_cast<double>(candidates.size()));
    if (auto format = predictor.predict(std::move(candidates[i]), rays, model, wish.maxBytes))
      rated.push_back(std::move(*format));
  }
  return rated;
}

std::vector<bool> frontierOf(std::span<const PredictedFormat> rated) {
  std::vector<std::size_t> order(rated.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    return std::pair(rated[a].bytes(), rated[a].time()) < std::pair(rated[b].bytes(), rated[b].time());
  });
  std::vector<bool> frontier(rated.size());
  double fastest = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    frontier[i] = rated[i].time() < fastest;
    fastest = std::min(fastest, rated[i].time());
  }
  return frontier;
}

std::optional<std::size_t> choose(std::span<const SizeTime> points, Wish::Objective objective) {
  if (points.empty())
    return std::nullopt;
  const auto best =
      std::ranges::min_element(points, {}, [&](const SizeTime &point) { return regret(point, objective); });
  return static_cast<std::size_t>(best - points.begin());
}

std::optional<std::size_t> choose(std::span<const PredictedFormat> rated, const Wish &wish) {
  std::vector<SizeTime> points;
  points.reserve(rated.size());
  for (const PredictedFormat &format : rated)
    points.push_back({static_cast<double>(format.bytes()), format.time()});
  return choose(points, wish.objective);
}

} // namespace voxc
