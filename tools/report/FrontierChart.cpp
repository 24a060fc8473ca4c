// Drawing charts. Places along x are shares of the width, those along y pixels; the axes' words stand outside
// the frame, in margins that style.css gives it.
#include "report/FrontierChart.h"

#include "plot/Labels.h"
#include "plot/Scale.h"
#include "report/Html.h"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace voxc::report {
namespace {

using plot::Box;
using plot::coordinate;
using plot::Scale;

constexpr double kHeight = 300;
constexpr double kLetters = 12.5;
constexpr int kTicks = 5;
/// The share of a label that may cover something; one for which there is no better place is left out.
constexpr double kMostCovered = 0.35;

/// Labels are placed for these widths; style.css shows the set that fits.
struct LabelSet {
  std::string_view name;
  double width;
};
constexpr std::array<LabelSet, 2> kLabelSets = {{{"wide", 470}, {"narrow", 286}}};

std::string share(double value) { return coordinate(value) + "%"; }

/// A place along x to a tenth of a pixel of any screen.
std::string fineShare(double value) {
  std::string text = std::to_string(value);
  return text.substr(0, text.find('.') + 3) + "%";
}

std::string mark(std::size_t family) { return "#m" + std::to_string(family); }

class Drawing {
public:
  explicit Drawing(const Chart &chart)
      : chart_(chart), x_({"", plot::Spacing::Bytes}, sizesWithRoom(), 0, 100, kTicks),
        y_({"", plot::Spacing::Linear}, valuesOf(&ChartPoint::speed), kHeight, 0, kTicks) {}

  std::string draw() const {
    std::string content = textTag("title", {}, chart_.title) + axes() + frontier();
    for (const LabelSet &set : kLabelSets)
      content += tag("g", {{"class", std::string(set.name)}, {"aria-hidden", "true"}}, labels(set.width));
    content += points();
    return tag("svg", {{"class", "chart"}, {"height", coordinate(kHeight)}, {"role", "group"}}, content);
  }

private:
  std::vector<double> valuesOf(double ChartPoint::*axis) const {
    std::vector<double> values;
    values.reserve(chart_.points.size());
    for (const ChartPoint &point : chart_.points)
      values.push_back(point.*axis);
    return values;
  }

  /// The sizes, and one that is smaller, for the labels of the smallest stand to its left.
  std::vector<double> sizesWithRoom() const {
    constexpr double kRoom = 1.7;
    std::vector<double> sizes = valuesOf(&ChartPoint::bytes);
    sizes.push_back(std::ranges::min(sizes) / kRoom);
    return sizes;
  }

  std::string axes() const {
    std::string text;
    for (const plot::Tick &tick : y_.ticks()) {
      const std::string y = coordinate(tick.place);
      text +=
          tag("line",
              {{"class", tick.place == kHeight ? "axis" : "grid"}, {"x2", "100%"}, {"y1", y}, {"y2", y}}, "");
      text += textTag("text", {{"class", "tick end"}, {"x", "-8"}, {"y", y}, {"dy", ".35em"}}, tick.text);
    }
    for (const plot::Tick &tick : x_.ticks()) {
      const std::string x = share(tick.place);
      text += tag("line",
                  {{"class", "axis"},
                   {"x1", x},
                   {"x2", x},
                   {"y1", coordinate(kHeight)},
                   {"y2", coordinate(kHeight + 5)}},
                  "");
      text +=
          textTag("text", {{"class", "tick middle"}, {"x", x}, {"y", coordinate(kHeight + 19)}}, tick.text);
    }
    text += textTag("text", {{"class", "unit"}, {"x", "-40"}, {"y", "-14"}}, "↑ " + chart_.speedLabel);
    return text + textTag("text", {{"class", "unit end"}, {"x", "100%"}, {"y", coordinate(kHeight + 38)}},
                          "Size, logarithmic →");
  }

  std::vector<const ChartPoint *> frontierPoints() const {
    std::vector<const ChartPoint *> points;
    for (const ChartPoint &point : chart_.points)
      if (point.onFrontier)
        points.push_back(&point);
    return points;
  }

  /// A staircase: the greatest speed that is to be had for a size, and below it what is dominated. Drawn in
  /// hundredths of the width, and stretched.
  std::string frontier() const {
    std::string stairs;
    for (const ChartPoint *point : frontierPoints()) {
      const std::string x = coordinate(x_.place(point->bytes)), y = coordinate(y_.place(point->speed));
      stairs += stairs.empty() ? "M" + x + "," + coordinate(kHeight) : "H" + x;
      stairs += "V" + y;
    }
    stairs += "H100";
    const std::string box = "0 0 100 " + coordinate(kHeight);
    return tag("svg",
               {{"width", "100%"},
                {"height", coordinate(kHeight)},
                {"viewBox", box},
                {"preserveAspectRatio", "none"}},
               tag("path", {{"class", "dominated"}, {"d", stairs + "V" + coordinate(kHeight) + "Z"}}, "") +
                   tag("path", {{"class", "frontier"}, {"d", stairs}}, ""));
  }

  /// Thin boxes along the stairs, which labels keep off; to be crossed by a riser harms a label less.
  std::vector<Box> stairs(double width) const {
    constexpr double kHalf = 2, kRiser = 0.75;
    std::vector<Box> boxes;
    double left = 0, bottom = kHeight;
    for (const ChartPoint *point : frontierPoints()) {
      const double x = x_.place(point->bytes) / 100 * width, y = y_.place(point->speed);
      boxes.push_back({left, bottom - kHalf, x, bottom + kHalf});
      boxes.push_back({x - kRiser, y, x + kRiser, bottom});
      left = x, bottom = y;
    }
    boxes.push_back({left, bottom - kHalf, width, bottom + kHalf});
    return boxes;
  }

  /// Each label stands in a frame of its own whose origin is the point.
  std::string labels(double width) const {
    std::vector<plot::LabelRequest> requests;
    std::vector<Box> others = stairs(width);
    for (const ChartPoint &point : chart_.points) {
      const double x = x_.place(point.bytes) / 100 * width, y = y_.place(point.speed);
      if (point.onFrontier)
        requests.push_back({point.label, x, y});
      else
        others.push_back({x - 8, y - 8, x + 8, y + 8});
    }
    const Box frame = {4, -4, width + 14, kHeight - 4};
    std::string text;
    for (const plot::PlacedLabel &label : placeLabels(requests, frame, kLetters, others))
      if (label.cost < kMostCovered * kLetters * plot::textWidth(label.text, kLetters))
        text += labelFrame(label, width);
    return text;
  }

  static std::string labelFrame(const plot::PlacedLabel &label, double width) {
    std::string content;
    if (label.hasLeader)
      content = tag("line",
                    {{"class", "leader"},
                     {"x2", coordinate(label.leaderX - label.pointX)},
                     {"y2", coordinate(label.leaderY - label.pointY)}},
                    "");
    content += textTag("text",
                       {{"class", "label"},
                        {"x", coordinate(label.x - label.pointX)},
                        {"y", coordinate(label.baseline - label.pointY)}},
                       label.text);
    return tag("svg",
               {{"x", fineShare(100 * label.pointX / width)},
                {"y", coordinate(label.pointY)},
                {"overflow", "visible"}},
               content);
  }

  /// Those of the frontier last, so that they lie on top.
  std::string points() const {
    std::string dominated, leading;
    for (const ChartPoint &point : chart_.points)
      (point.onFrontier ? leading : dominated) += drawPoint(point);
    return dominated + leading;
  }

  std::string drawPoint(const ChartPoint &point) const {
    const std::string x = fineShare(x_.place(point.bytes)), y = coordinate(y_.place(point.speed));
    std::string content = textTag("title", {}, point.note);
    if (point.hasErrors)
      content += tag("circle", {{"class", "ring"}, {"cx", x}, {"cy", y}, {"r", "10"}}, "");
    content += tag("circle", {{"class", "reach"}, {"cx", x}, {"cy", y}, {"r", "12"}}, "");
    content += tag("use", {{"href", mark(point.family)}, {"x", x}, {"y", y}}, "");
    const std::string style = "point f" + std::to_string(point.family) + (point.onFrontier ? " on" : "");
    return tag("a", {{"class", style}, {"href", point.target}, {"data-format", std::to_string(point.format)}},
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
  for (std::size_t family = 0; family < kOutlines.size(); ++family)
    marks += tag("path", {{"id", mark(family).substr(1)}, {"d", std::string(kOutlines[family])}}, "");
  return tag("svg", {{"class", "definitions"}, {"width", "0"}, {"height", "0"}, {"aria-hidden", "true"}},
             tag("defs", {}, marks));
}

std::string legendMark(std::size_t family) {
  return tag(
      "svg",
      {{"class", "key on f" + std::to_string(family)}, {"viewBox", "-8 -8 16 16"}, {"aria-hidden", "true"}},
      tag("use", {{"href", mark(family)}}, ""));
}

} // namespace voxc::report
