// Where the points of a search lie on a chart of size against speed.
#pragma once

#include "view/Scale.h"
#include "view/SearchPoints.h"

#include <glm/vec2.hpp>

#include <optional>
#include <vector>

namespace voxc::view {

/// Places in pixels from the chart's top left corner: sizes to the right by their logarithm, speeds upwards
/// from 0.
class SearchChart {
public:
  /// Precondition: there is a point.
  SearchChart(const SearchPoints &search, double width, double height);

  const std::vector<glm::dvec2> &places() const { return places_; }
  /// The staircase of what is to be had for a size, from left to right.
  const std::vector<glm::dvec2> &frontier() const { return frontier_; }
  const std::vector<Tick> &sizeTicks() const { return x_.ticks(); }
  const std::vector<Tick> &speedTicks() const { return y_.ticks(); }
  /// The point that lies nearest to `place`, and at most `reach` pixels from it.
  std::optional<std::size_t> nearest(glm::dvec2 place, double reach) const;

private:
  Scale x_, y_;
  std::vector<glm::dvec2> places_, frontier_;
};

} // namespace voxc::view
