// Plots as self-contained SVG: no script, no network, light and dark as the reader's screen is, and a layout
// of its own for narrow screens.
#pragma once

#include <string>
#include <vector>

namespace voxc::plot {

/// How values become places.
enum class Spacing {
  Linear,  ///< From 0.
  Decades, ///< Logarithmic, ticks at powers of 10; 0 may have a place of its own before the least of them.
  Octaves, ///< Logarithmic, ticks at powers of 2; no 0.
  Bytes,   ///< The same, with ticks told as sizes of memory.
};

struct Axis {
  std::string label; ///< With its unit.
  Spacing spacing = Spacing::Linear;
  double least = 0; ///< `Decades`: the smallest value that can occur beside 0; then both have a place always.
};

struct Point {
  double x = 0;
  double y = 0;
  std::string note; ///< Shown when pointed at.
};

/// Points of one colour and mark.
struct Series {
  std::string label;
  std::vector<Point> points; ///< From left to right if they are connected.
};

struct Plot {
  std::string title;
  std::string subtitle;
  Axis x;
  Axis y;
  std::vector<Series> series;
  bool connected = false; ///< Lines with a legend; otherwise labels at the first point of each series, where
                          ///< there is room.
};

/// The plot as an SVG document, which may stand alone or inside HTML. Values that are not finite are left
/// out.
std::string toSvg(const Plot &plot);

} // namespace voxc::plot
