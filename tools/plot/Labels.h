// Labels beside points, placed so that none covers another, a point, or the frame.
#pragma once

#include <string>
#include <vector>

namespace voxc::plot {

struct Box {
  double left, top, right, bottom;
};

/// Where a label went: its text begins at (x, baseline), and a line leads to it if it stands far off.
struct PlacedLabel {
  std::string text;
  double x, baseline;
  double pointX, pointY;
  double leaderX, leaderY; ///< The leader's end at the text.
  bool hasLeader;
  double cost; ///< How much it covers, mostly: an area in square units.
};

struct LabelRequest {
  std::string text;
  double x, y; ///< The point.
};

/// About how wide a text is in the common sans-serif fonts.
double textWidth(const std::string &text, double fontSize);

/// Places the labels in their order inside `frame`, away from their points and from `obstacles`. One for
/// which no place is left stands where it covers least.
std::vector<PlacedLabel> placeLabels(const std::vector<LabelRequest> &requests, const Box &frame,
                                     double fontSize, std::vector<Box> obstacles = {});

/// The labels for which there is room right beside their points: one that would cover a label, a point or an
/// obstacle, or leave the frame, is left out. Earlier ones take their places first.
std::vector<PlacedLabel> placeWhereFree(const std::vector<LabelRequest> &requests, const Box &frame,
                                        double fontSize, std::vector<Box> obstacles);

/// What the text of a label takes.
Box textBox(const PlacedLabel &label, double fontSize);

} // namespace voxc::plot
