// Drawing charts of size against speed.
#include "report/FrontierChart.h"

#include "plot/Scale.h"
#include "report/ChartFrame.h"
#include "report/ChartLabels.h"
#include "report/Html.h"

#include <algorithm>
#include <array>

namespace voxc::report {
namespace {

using plot::coordinate;
using plot::Scale;

constexpr int kTicks = 5;

/// How points look that lead, are as good, and are beaten.
constexpr std::array<const char *, 3> kPlaceStyles = {" on", " good", ""};

/// The sizes, and one that is smaller, for the labels of the smallest stand to its left.
std::vector<double> sizesWithRoom(const ChartRange &range) {
  constexpr double kRoom = 1.7;
  return {range.leastBytes / kRoom, range.mostBytes};
}

class Drawing {
public:
  explicit Drawing(const Chart &chart)
      : chart_(chart), x_({"", plot::Spacing::Bytes}, sizesWithRoom(chart.range), 0, 100, kTicks),
        y_({"", plot::Spacing::Linear}, {chart.range.mostSpeed}, kChartHeight, 0, kTicks) {}

  std::string draw() const {
    const std::string content = textTag("title", {}, chart_.title) +
                                axes(x_, y_, "Size, logarithmic", chart_.speedLabel) + frontier() +
                                chartLabels(chart_, x_, y_) + points();
    return chartElement(chart_.points.size(), content);
  }

private:
  /// A staircase: the greatest speed that is to be had for a size, and below it what is dominated. Drawn in
  /// hundredths of the width, and stretched.
  std::string frontier() const {
    std::string stairs;
    for (const ChartPoint &point : chart_.points)
      if (point.place == Place::Leading) {
        const std::string x = coordinate(x_.place(point.bytes));
        stairs += stairs.empty() ? "M" + x + "," + coordinate(kChartHeight) : "H" + x;
        stairs += "V" + coordinate(y_.place(point.speed.median));
      }
    stairs += "H100";
    const std::string height = coordinate(kChartHeight);
    return tag("svg",
               {{"width", "100%"},
                {"height", height},
                {"viewBox", "0 0 100 " + height},
                {"preserveAspectRatio", "none"}},
               tag("path", {{"class", "dominated"}, {"d", stairs + "V" + height + "Z"}}, "") +
                   tag("path", {{"class", "frontier"}, {"d", stairs}}, ""));
  }

  /// Those of the frontier last, so that they lie on top.
  std::string points() const {
    std::array<std::string, kPlaceStyles.size()> layers;
    for (const ChartPoint &point : chart_.points)
      layers[static_cast<std::size_t>(point.place)] += drawPoint(point);
    return layers[2] + layers[1] + layers[0];
  }

  /// From the slowest round to the fastest, as far as the chart reaches.
  std::string rounds(const ChartPoint &point, const std::string &x) const {
    const double top = std::max(0.0, y_.place(point.speed.max)), bottom = y_.place(point.speed.min);
    return tag(
        "line",
        {{"class", "rounds"}, {"x1", x}, {"x2", x}, {"y1", coordinate(top)}, {"y2", coordinate(bottom)}}, "");
  }

  std::string drawPoint(const ChartPoint &point) const {
    const std::string x = fineShare(x_.place(point.bytes)), y = coordinate(y_.place(point.speed.median));
    const bool isSmall = isCrowded(chart_.points.size()) && point.place == Place::Beaten;
    std::string content = textTag("title", {}, point.note) + rounds(point, x);
    if (point.hasErrors)
      content += tag("circle", {{"class", "ring"}, {"cx", x}, {"cy", y}, {"r", "10"}}, "");
    content += tag("use", {{"href", markReference(point.family, isSmall)}, {"x", x}, {"y", y}}, "");
    const std::string style =
        "point f" + std::to_string(point.family) + kPlaceStyles[static_cast<std::size_t>(point.place)];
    return tag("a",
               {{"class", style}, {"href", point.target}, {"data-variant", std::to_string(point.variant)}},
               content);
  }

  const Chart &chart_;
  Scale x_;
  Scale y_;
};

} // namespace

std::string toSvg(const Chart &chart) { return Drawing(chart).draw(); }

std::string markDefinitions() {
  /// Outlines about the origin, of equal weight to the eye.
  static constexpr std::array<std::string_view, 6> kOutlines = {
      "M0-7.2 7.2 0 0 7.2-7.2 0Z",
      "M-5.5 0A5.5 5.5 0 1 1 5.5 0 5.5 5.5 0 1 1-5.5 0Z",
      "M0-6.8 6.4 4.8H-6.4Z",
      "M0 6.8 6.4-4.8H-6.4Z",
      "M-5-5H5V5H-5Z",
      "M-2-6H2V-2H6V2H2V6H-2V2H-6V-2H-2Z"};
  std::string marks;
  for (std::size_t family = 0; family < kOutlines.size(); ++family) {
    const std::string outline(kOutlines[family]);
    marks += tag("path", {{"id", markReference(family).substr(1)}, {"d", outline}}, "");
    marks +=
        tag("path",
            {{"id", markReference(family, true).substr(1)}, {"d", outline}, {"transform", "scale(.65)"}}, "");
  }
  return tag("svg", {{"class", "definitions"}, {"width", "0"}, {"height", "0"}, {"aria-hidden", "true"}},
             tag("defs", {}, marks));
}

std::string legendMark(std::size_t family) {
  return tag(
      "svg",
      {{"class", "key on f" + std::to_string(family)}, {"viewBox", "-8 -8 16 16"}, {"aria-hidden", "true"}},
      tag("use", {{"href", markReference(family)}}, ""));
}

} // namespace voxc::report
