// Drawing plots: twice, for wide screens and for narrow ones; a style sheet shows the one that fits.
#include "plot/Plot.h"

#include "plot/Labels.h"
#include "plot/Scale.h"
#include "plot/Svg.h"

#include <array>
#include <cmath>

namespace voxc::plot {
namespace {

constexpr double kWidth = 800;
constexpr double kHeight = 560;

/// Colours that keep apart in both schemes and for the colour-blind (after Okabe and Ito).
constexpr std::string_view kStyle = R"(
.voxc-plot{--paper:#fff;--ink:#1c2128;--dim:#59636e;--grid:#dfe3e8;--c0:#0067a8;--c1:#c14a00;--c2:#007f5c;--c3:#a8457f;--c4:#8a6a00;--c5:#2b8fc4;font-family:system-ui,"Segoe UI",Roboto,"DejaVu Sans",sans-serif;max-width:100%;height:auto}
@media(prefers-color-scheme:dark){.voxc-plot{--paper:#0d1117;--ink:#e6edf3;--dim:#9da7b3;--grid:#2b323b;--c0:#58b4ee;--c1:#ff9350;--c2:#3ecf9f;--c3:#ee8fc6;--c4:#e3c04a;--c5:#9ad4f5}}
.voxc-plot .narrow{display:none}
@media(max-width:520px){.voxc-plot .wide{display:none}.voxc-plot .narrow{display:inline}}
.voxc-plot .paper{fill:var(--paper)}.voxc-plot text{fill:var(--ink)}.voxc-plot .dim{fill:var(--dim)}
.voxc-plot .grid{stroke:var(--grid);stroke-width:1}.voxc-plot .axis{stroke:var(--dim);stroke-width:1.5}
.voxc-plot .break{stroke:var(--dim);stroke-width:1.5;stroke-dasharray:2 4}.voxc-plot .leader{stroke:var(--dim);stroke-width:1}
.voxc-plot .line{fill:none;stroke-width:2.5;stroke-linejoin:round}.voxc-plot .halo{paint-order:stroke;stroke:var(--paper);stroke-width:4px;stroke-linejoin:round}
)";
constexpr int kColours = 6;

std::string colour(std::size_t series) { return "var(--c" + std::to_string(series % kColours) + ")"; }

std::string line(std::string_view style, double x1, double y1, double x2, double y2) {
  return element("line", {{"class", std::string(style)},
                          {"x1", coordinate(x1)},
                          {"y1", coordinate(y1)},
                          {"x2", coordinate(x2)},
                          {"y2", coordinate(y2)}});
}

std::string text(std::string_view style, std::string_view anchor, double x, double y, double size,
                 std::string_view words) {
  return element("text",
                 {{"class", std::string(style)},
                  {"text-anchor", std::string(anchor)},
                  {"x", coordinate(x)},
                  {"y", coordinate(y)},
                  {"font-size", coordinate(size)}},
                 escaped(words));
}

/// The outline of a series' mark around the origin, for a radius of 1.
constexpr std::array<std::string_view, 5> kMarks = {
    "M-1,0A1,1 0 1,1 1,0A1,1 0 1,1 -1,0Z", "M-.9,-.9H.9V.9H-.9Z", "M0,-1.2L1.1,.8H-1.1Z",
    "M0,-1.25L1.25,0L0,1.25L-1.25,0Z", "M-1.1,-.8H1.1L0,1.2Z"};

std::string mark(std::size_t series, double x, double y, double radius, std::string_view note) {
  const std::string place =
      "translate(" + coordinate(x) + " " + coordinate(y) + ") scale(" + coordinate(radius) + ")";
  const std::string title = note.empty() ? "" : "<title>" + escaped(note) + "</title>";
  return element(
      "path",
      {{"d", std::string(kMarks[series % kMarks.size()])}, {"fill", colour(series)}, {"transform", place}},
      title);
}

bool isDrawn(const Point &point) { return std::isfinite(point.x) && std::isfinite(point.y); }

std::vector<double> coordinatesOf(const Plot &plot, double Point::*axis) {
  std::vector<double> values;
  for (const Series &series : plot.series)
    for (const Point &point : series.points)
      if (isDrawn(point))
        values.push_back(point.*axis);
  return values;
}

/// One of the two drawings: all sizes follow from that of the letters.
class Drawing {
public:
  Drawing(const Plot &plot, std::string_view name, double fontSize, bool hasLegend)
      : plot_(plot), name_(name), size_(fontSize), hasLegend_(hasLegend), frame_(makeFrame()),
        x_(plot.x, coordinatesOf(plot, &Point::x), frame_.left, frame_.right,
           static_cast<int>((frame_.right - frame_.left) / (4.5 * fontSize))),
        y_(plot.y, coordinatesOf(plot, &Point::y), frame_.bottom, frame_.top,
           static_cast<int>((frame_.bottom - frame_.top) / (3 * fontSize))) {}

  std::string draw() {
    heading();
    axes();
    for (std::size_t i = 0; i < plot_.series.size(); ++i)
      drawSeries(i);
    if (!hasLegend_)
      labels();
    return element("g", {{"class", std::string(name_)}}, "\n" + text_);
  }

private:
  double rowHeight() const { return 1.5 * size_; }

  /// Rows of the legend, as many series in each as fit.
  std::vector<std::vector<std::size_t>> legendRows() const {
    std::vector<std::vector<std::size_t>> rows;
    double x = kWidth;
    for (std::size_t i = 0; hasLegend_ && i < plot_.series.size(); ++i) {
      const double width = textWidth(plot_.series[i].label, size_) + 3 * size_;
      if (x + width > kWidth - size_) {
        rows.emplace_back();
        x = size_;
      }
      rows.back().push_back(i);
      x += width;
    }
    return rows;
  }

  /// The title with its subtitle, the legend and the vertical axis's label stand above the frame.
  Box makeFrame() const {
    const double above =
        1.9 * size_ + 1.6 * size_ + rowHeight() * (static_cast<double>(legendRows().size()) + 1);
    return {4 * size_, above + 0.9 * size_, kWidth - 1.6 * size_, kHeight - 3.7 * size_};
  }

  void heading() {
    text_ += element("text",
                     {{"x", coordinate(size_)},
                      {"y", coordinate(1.9 * size_)},
                      {"font-size", coordinate(1.25 * size_)},
                      {"font-weight", "600"}},
                     escaped(plot_.title));
    text_ += text("dim", "start", size_, 3.5 * size_, 0.95 * size_, plot_.subtitle);
    double y = 3.5 * size_ + rowHeight();
    for (const std::vector<std::size_t> &row : legendRows()) {
      double x = 1.5 * size_;
      for (const std::size_t i : row) {
        text_ += mark(i, x, y - 0.35 * size_, 0.36 * size_, {});
        text_ += text("", "start", x + 0.8 * size_, y, size_, plot_.series[i].label);
        x += textWidth(plot_.series[i].label, size_) + 3 * size_;
      }
      y += rowHeight();
    }
  }

  void axes() {
    for (const Tick &tick : y_.ticks()) {
      text_ += line("grid", frame_.left, tick.place, frame_.right, tick.place);
      text_ += text("dim", "end", frame_.left - 0.5 * size_, tick.place + 0.35 * size_, size_, tick.text);
    }
    for (const Tick &tick : x_.ticks()) {
      text_ += line("grid", tick.place, frame_.top, tick.place, frame_.bottom);
      text_ += text("dim", "middle", tick.place, frame_.bottom + 1.4 * size_, size_, tick.text);
    }
    text_ += line("axis", frame_.left, frame_.bottom, frame_.right, frame_.bottom);
    const bool isBroken = std::isfinite(y_.breakPlace());
    const double broken = isBroken ? y_.breakPlace() : frame_.bottom;
    text_ += line("axis", frame_.left, frame_.top, frame_.left, broken - (isBroken ? 0.5 * size_ : 0));
    if (isBroken)
      text_ += line("break", frame_.left, broken - 0.5 * size_, frame_.left, frame_.bottom);
    text_ += text("", "start", size_, frame_.top - 0.8 * size_, size_, plot_.y.label);
    text_ += text("", "end", frame_.right, kHeight - 0.8 * size_, size_, plot_.x.label);
  }

  void drawSeries(std::size_t index) {
    std::string path, marks;
    for (const Point &point : plot_.series[index].points) {
      if (!isDrawn(point))
        continue;
      const double x = x_.place(point.x), y = y_.place(point.y);
      path += (path.empty() ? "M" : "L") + coordinate(x) + "," + coordinate(y);
      marks += mark(index, x, y, (plot_.connected ? 0.3 : 0.42) * size_, point.note);
    }
    if (plot_.connected && !path.empty())
      text_ += element("path", {{"class", "line"}, {"stroke", colour(index)}, {"d", path}});
    text_ += marks;
  }

  void labels() {
    std::vector<LabelRequest> requests;
    for (const Series &series : plot_.series)
      if (!series.points.empty() && isDrawn(series.points.front()))
        requests.push_back(
            {series.label, x_.place(series.points.front().x), y_.place(series.points.front().y)});
    const Box room = {frame_.left, frame_.top, kWidth - 0.5 * size_, frame_.bottom};
    for (const PlacedLabel &label : placeLabels(requests, room, size_)) {
      if (label.hasLeader)
        text_ += line("leader", label.pointX, label.pointY, label.leaderX, label.leaderY);
      text_ += text("halo", "start", label.x, label.baseline, size_, label.text);
    }
  }

  const Plot &plot_;
  std::string_view name_;
  double size_;
  bool hasLegend_; ///< Otherwise each series is labelled at its first point.
  Box frame_;
  Scale x_;
  Scale y_;
  std::string text_;
};

} // namespace

std::string toSvg(const Plot &plot) {
  // On a telephone 800 units are about 360 pixels.
  constexpr double kWideLetters = 15, kNarrowLetters = 24;
  const std::string box = "0 0 " + coordinate(kWidth) + " " + coordinate(kHeight);
  const std::string content = "\n" + element("title", {}, escaped(plot.title)) +
                              element("style", {}, kStyle) +
                              element("rect", {{"class", "paper"}, {"width", "100%"}, {"height", "100%"}}) +
                              Drawing(plot, "wide", kWideLetters, plot.connected).draw() +
                              Drawing(plot, "narrow", kNarrowLetters, true).draw();
  return element("svg",
                 {{"xmlns", "http://www.w3.org/2000/svg"},
                  {"class", "voxc-plot"},
                  {"viewBox", box},
                  {"width", coordinate(kWidth)},
                  {"role", "img"}},
                 content);
}

} // namespace voxc::plot
