// The Pareto frontier by one sweep from the smallest to the largest.
#include "report/Pareto.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace voxc::report {

std::vector<bool> paretoFrontier(std::span<const SizeSpeed> points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    return points[a].size != points[b].size ? points[a].size < points[b].size
                                            : points[a].speed > points[b].speed;
  });
  std::vector<bool> isOn(points.size());
  SizeSpeed best{-1, -std::numeric_limits<double>::infinity()};
  for (const std::size_t i : order) {
    const bool equalsBest = points[i].size == best.size && points[i].speed == best.speed;
    isOn[i] = equalsBest || points[i].speed > best.speed;
    if (isOn[i])
      best = points[i];
  }
  return isOn;
}

} // namespace voxc::report
