// Placing the names of a chart.
#include "report/ChartLabels.h"

#include "plot/Labels.h"
#include "report/ChartFrame.h"
#include "report/Html.h"

#include <algorithm>
#include <array>

namespace voxc::report {
namespace {

using plot::Box;
using plot::coordinate;
using plot::LabelRequest;
using plot::PlacedLabel;
using plot::Scale;

constexpr double kLetters = 12.5, kSmallLetters = 11;
/// The share of a label that may cover something; one for which there is no better place is left out.
constexpr double kMostCovered = 0.25;
/// What a point takes, from its middle.
constexpr double kReach = 7;

struct LabelSet {
  std::string_view name;
  double width;
  std::size_t mostOthers; ///< More names of points that do not lead would hide the frontier.
};
constexpr double kFullWidth = 1060;
constexpr std::array<LabelSet, 3> kLabelSets = {
    {{"wide", 470, 14}, {"narrow", 286, 4}, {"full", kFullWidth, 40}}};

class Labelling {
public:
  Labelling(const Chart &chart, const Scale &x, const Scale &y, const LabelSet &set)
      : chart_(chart), x_(x), y_(y), set_(set), frame_{4, -4, set.width + 14, kChartHeight - 4} {}

  std::string draw() {
    std::vector<LabelRequest> leading;
    std::vector<const ChartPoint *> others;
    for (const ChartPoint &point : chart_.points)
      if (point.place == Place::Leading)
        leading.push_back(request(point));
      else
        others.push_back(&point);
    taken_ = stairs();
    for (const ChartPoint *point : others)
      take(request(*point));
    for (const PlacedLabel &label : placeLabels(leading, frame_, kLetters, taken_))
      if (label.cost < kMostCovered * kLetters * plot::textWidth(label.text, kLetters))
        add(label, "label", kLetters);
    for (const LabelRequest &one : leading)
      take(one);
    std::ranges::stable_sort(others, std::greater(), &ChartPoint::share);
    addOthers(others);
    return text_;
  }

private:
  LabelRequest request(const ChartPoint &point) const {
    return {point.label, x_.place(point.bytes) / 100 * set_.width, y_.place(point.speed.median)};
  }

  void take(const LabelRequest &point) {
    taken_.push_back({point.x - kReach, point.y - kReach, point.x + kReach, point.y + kReach});
  }

  /// Names of one place each, nearest to the frontier first.
  void addOthers(const std::vector<const ChartPoint *> &others) {
    std::vector<LabelRequest> requests;
    requests.reserve(others.size());
    for (const ChartPoint *point : others)
      requests.push_back(request(*point));
    std::size_t count = 0;
    for (const PlacedLabel &label : placeWhereFree(requests, frame_, kSmallLetters, taken_))
      if (count++ < set_.mostOthers)
        add(label, "label small", kSmallLetters);
  }

  /// Thin boxes along the stairs of the frontier, which labels keep off; to be crossed by a riser harms a
  /// label less.
  std::vector<Box> stairs() const {
    constexpr double kHalf = 2, kRiser = 0.75;
    std::vector<Box> boxes;
    double left = 0, bottom = kChartHeight;
    for (const ChartPoint &point : chart_.points) {
      if (point.place != Place::Leading)
        continue;
      const double x = x_.place(point.bytes) / 100 * set_.width, y = y_.place(point.speed.median);
      boxes.push_back({left, bottom - kHalf, x, bottom + kHalf});
      boxes.push_back({x - kRiser, y, x + kRiser, bottom});
      left = x, bottom = y;
    }
    boxes.push_back({left, bottom - kHalf, set_.width, bottom + kHalf});
    return boxes;
  }

  /// Each label stands in a frame of its own whose origin is the point.
  void add(const PlacedLabel &label, const char *style, double letters) {
    std::string content;
    if (label.hasLeader)
      content = tag("line",
                    {{"class", "leader"},
                     {"x2", coordinate(label.leaderX - label.pointX)},
                     {"y2", coordinate(label.leaderY - label.pointY)}},
                    "");
    content += textTag("text",
                       {{"class", style},
                        {"x", coordinate(label.x - label.pointX)},
                        {"y", coordinate(label.baseline - label.pointY)}},
                       label.text);
    text_ += tag("svg",
                 {{"x", fineShare(100 * label.pointX / set_.width)},
                  {"y", coordinate(label.pointY)},
                  {"overflow", "visible"}},
                 content);
    taken_.push_back(plot::textBox(label, letters));
  }

  const Chart &chart_;
  const Scale &x_;
  const Scale &y_;
  const LabelSet &set_;
  Box frame_;
  std::vector<Box> taken_;
  std::string text_;
};

} // namespace

std::string chartLabels(const Chart &chart, const Scale &x, const Scale &y) {
  std::string text;
  for (const LabelSet &set : kLabelSets)
    if (set.width < kFullWidth || chart.isAlone)
      text += tag("g", {{"class", std::string(set.name)}, {"aria-hidden", "true"}},
                  Labelling(chart, x, y, set).draw());
  return text;
}

} // namespace voxc::report
