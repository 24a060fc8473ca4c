// Size against speed with the Pareto frontier, as SVG that lies inside the page: as wide as there is room,
// with letters that keep their size.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace voxc::report {

struct ChartPoint {
  double bytes = 0;
  double speed = 0;
  std::size_t family = 0; ///< Its mark and colour.
  std::size_t format = 0; ///< Points of one format are shown together.
  bool onFrontier = false;
  bool hasErrors = false;
  std::string label;  ///< Drawn beside points of the frontier.
  std::string note;   ///< Several lines, shown when pointed at or focused; the first is a heading.
  std::string target; ///< Where its link leads: "#r12".
};

struct Chart {
  std::string title; ///< For readers who do not see it.
  std::string speedLabel;
  std::vector<ChartPoint> points; ///< One at least, with positive sizes, from small to large.
};

std::string toSvg(const Chart &chart);

/// The marks that charts refer to, once a page.
std::string markDefinitions();
/// A family's mark by itself, for the legend.
std::string legendMark(std::size_t family);

} // namespace voxc::report
