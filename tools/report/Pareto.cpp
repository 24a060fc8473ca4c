// The Pareto frontier by one sweep from the smallest to the largest.
#include "report/Pareto.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace voxc::report {
namespace {

/// From small to large, and of equally large ones from fast to slow.
std::vector<std::size_t> orderOf(std::span<const SizeSpeed> points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return points[a].size != points[b].size ? points[a].size < points[b].size
                                            : points[a].speed > points[b].speed;
  });
  return order;
}

} // namespace

std::vector<bool> paretoFrontier(std::span<const SizeSpeed> points) {
  std::vector<bool> isOn(points.size());
  SizeSpeed best{-1, -std::numeric_limits<double>::infinity()};
  for (const std::size_t i : orderOf(points)) {
    const bool equalsBest = points[i].size == best.size && points[i].speed == best.speed;
    isOn[i] = equalsBest || points[i].speed > best.speed;
    if (isOn[i])
      best = points[i];
  }
  return isOn;
}

std::vector<Standing> standings(std::span<const MeasuredPoint> points) {
  std::vector<SizeSpeed> medians;
  medians.reserve(points.size());
  for (const MeasuredPoint &point : points)
    medians.push_back({point.bytes, point.speed.median});
  const std::vector<bool> isOn = paretoFrontier(medians);
  std::vector<Standing> standings(points.size());
  const std::size_t none = points.size();
  std::size_t leader = none;
  for (const std::size_t i : orderOf(medians)) {
    const bool isAsFast = leader != none && areEqual(points[i].speed, points[leader].speed);
    if (isOn[i] && !isAsFast)
      leader = i;
    const bool isHardlyLarger = points[i].bytes <= points[leader].bytes * (1 + kHardlyLarger);
    standings[i] = {leader == i                  ? Place::Leading
                    : isAsFast && isHardlyLarger ? Place::AsGood
                                                 : Place::Beaten,
                    leader};
  }
  return standings;
}

} // namespace voxc::report
