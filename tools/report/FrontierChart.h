// Size against speed with the Pareto frontier, as SVG that lies inside the page: as wide as there is room,
// with letters that keep their size.
#pragma once

#include "bench/Record.h"
#include "report/Pareto.h"

#include <cstddef>
#include <string>
#include <vector>

namespace voxc::report {

struct ChartPoint {
  double bytes = 0;
  tool::bench::Speed speed; ///< Its rounds are drawn from the slowest to the fastest.
  std::size_t family = 0;   ///< Its mark and colour.
  std::size_t variant = 0;  ///< Points of one variant are shown together.
  Place place = Place::Beaten;
  double share = 1; ///< Its speed over that of its rival: those that come close are labelled first.
  bool hasErrors = false;
  std::string label;  ///< Drawn beside it where there is room, of leading ones first.
  std::string note;   ///< Several lines, shown when pointed at or focused; the first is a heading.
  std::string target; ///< Where its link leads: "#r12".
};

/// What the axes show; the same for charts that stand side by side to be compared.
struct ChartRange {
  double leastBytes = 0, mostBytes = 0;
  double mostSpeed = 0; ///< The speeds begin at 0.
};

struct Chart {
  std::string title; ///< For readers who do not see it.
  std::string speedLabel;
  bool isAlone = false; ///< No chart stands beside it: it has the whole width of the page.
  ChartRange range;
  std::vector<ChartPoint> points; ///< One at least, with positive sizes, from small to large.
};

std::string toSvg(const Chart &chart);

/// The marks that charts refer to, once a page.
std::string markDefinitions();
/// A family's mark by itself, for the legend.
std::string legendMark(std::size_t family);

} // namespace voxc::report
