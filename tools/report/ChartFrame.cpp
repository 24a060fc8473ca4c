// The frame of a chart.
#include "report/ChartFrame.h"

#include "report/Html.h"

namespace voxc::report {

using plot::coordinate;

std::string share(double value) { return coordinate(value) + "%"; }

std::string fineShare(double value) {
  std::string text = std::to_string(value);
  return text.substr(0, text.find('.') + 3) + "%";
}

std::string axes(const plot::Scale &x, const plot::Scale &y, const std::string &xName,
                 const std::string &yName) {
  const std::string bottom = coordinate(kChartHeight);
  std::string text;
  for (const plot::Tick &tick : y.ticks()) {
    const std::string place = coordinate(tick.place);
    text +=
        tag("line",
            {{"class", place == bottom ? "axis" : "grid"}, {"x2", "100%"}, {"y1", place}, {"y2", place}}, "");
    text += textTag("text", {{"class", "tick end"}, {"x", "-8"}, {"y", place}, {"dy", ".35em"}}, tick.text);
  }
  for (const plot::Tick &tick : x.ticks()) {
    const std::string place = share(tick.place);
    text += tag("line",
                {{"class", "axis"},
                 {"x1", place},
                 {"x2", place},
                 {"y1", bottom},
                 {"y2", coordinate(kChartHeight + 5)}},
                "");
    text += textTag("text", {{"class", "tick middle"}, {"x", place}, {"y", coordinate(kChartHeight + 19)}},
                    tick.text);
  }
  text += textTag("text", {{"class", "unit"}, {"x", "-40"}, {"y", "-14"}}, "↑ " + yName);
  return text + textTag("text", {{"class", "unit end"}, {"x", "100%"}, {"y", coordinate(kChartHeight + 38)}},
                        xName + " →");
}

bool isCrowded(std::size_t points) {
  constexpr std::size_t kCrowd = 60;
  return points > kCrowd;
}

std::string chartElement(std::size_t points, const std::string &content) {
  return tag("svg",
             {{"class", isCrowded(points) ? "chart crowded" : "chart"},
              {"height", coordinate(kChartHeight)},
              {"role", "group"}},
             content);
}

std::string markReference(std::size_t family, bool isSmall) {
  return (isSmall ? "#s" : "#m") + std::to_string(family);
}

} // namespace voxc::report
