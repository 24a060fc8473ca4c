// Charts of searches.
#include "view/SearchChart.h"

#include <glm/geometric.hpp>

namespace voxc::view {
namespace {

constexpr int kTicks = 4;

/// From left to right, with a little room before the smallest.
std::vector<double> sizes(const SearchPoints &search) {
  constexpr double kRoom = 1.2;
  std::vector<double> values = {search.points.front().bytes / kRoom};
  for (const SearchPoint &point : search.points)
    values.push_back(point.bytes * kRoom);
  return values;
}

std::vector<double> speeds(const SearchPoints &search) {
  constexpr double kRoom = 1.05;
  std::vector<double> values = {0};
  for (const SearchPoint &point : search.points)
    values.push_back(point.mraysPerS * kRoom);
  return values;
}

} // namespace

SearchChart::SearchChart(const SearchPoints &search, double width, double height)
    : x_(Scale::bytes(sizes(search), 0, width, kTicks)),
      y_(Scale::linear(speeds(search), height, 0, kTicks)) {
  for (const SearchPoint &point : search.points) {
    places_.emplace_back(x_.place(point.bytes), y_.place(point.mraysPerS));
    if (!point.isLeading)
      continue;
    const glm::dvec2 place = places_.back();
    frontier_.emplace_back(place.x, frontier_.empty() ? height : frontier_.back().y);
    frontier_.push_back(place);
  }
  if (!frontier_.empty())
    frontier_.emplace_back(width, frontier_.back().y);
}

std::optional<std::size_t> SearchChart::nearest(glm::dvec2 place, double reach) const {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (const double distance = glm::distance(places_[i], place); distance <= reach) {
      reach = distance;
      best = i;
    }
  return best;
}

} // namespace voxc::view
