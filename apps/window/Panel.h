// What lies over the picture: the state of the viewer, and what can be chosen.
#pragma once

#include "view/Viewer.h"

#include <string>

namespace voxc::view {

class Panel {
public:
  /// Draws a frame of it; choices go to the viewer.
  void draw(Viewer &viewer);
  /// Whether keys are for the text that is being written.
  bool isWriting() const { return isWriting_; }
  /// Whether a place of the window, in pixels, is covered by it.
  bool covers(double column, double row) const;
  /// Whether it has to be drawn once more: it has become longer or shorter, and ImGui gives a window the size
  /// of what the last frame drew in it.
  bool isSettling() const { return isSettling_; }
  /// Closes the list that is open, with the next frame. False if there is none.
  bool closeList();

private:
  void drawScene(Viewer &viewer);
  void drawFormat(Viewer &viewer);
  void drawFrames(Viewer &viewer);
  void drawPicture(Viewer &viewer);
  void drawPick(const Viewer &viewer);
  void drawChart(Viewer &viewer);
  void drawHelp();
  void drawQuestion();

  std::string text_;  ///< The format that is being written.
  std::string shown_; ///< The scene's format, when it was last looked at.
  bool isWriting_ = false;
  bool hasPopup_ = false; ///< A list is open, which may lie anywhere.
  bool closesList_ = false;
  bool isSettling_ = false;
  float length_ = 0;              ///< Of what was drawn in it; 0: nothing.
  double width_ = 0, height_ = 0; ///< 0: nothing is drawn.
};

} // namespace voxc::view
