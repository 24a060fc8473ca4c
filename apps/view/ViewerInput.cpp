// What the viewer does with input.
#include "view/Viewer.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace voxc::view {
namespace {

/// A pixel of dragging turns by so much, in radians; a step of the wheel brings so much nearer.
constexpr double kTurnOfPixel = glm::radians(0.25), kNearerOfStep = 1.15;

} // namespace

void Viewer::press(Action action) {
  struct Row {
    Action action;
    void (*act)(Viewer &viewer);
  };
  static constexpr Row kRows[] = {
      {Action::ToggleFly, [](Viewer &viewer) { viewer.setFlying(!viewer.state_.isFlying); }},
      {Action::Orbit, [](Viewer &viewer) { viewer.orbitTouched(); }},
      {Action::NextView, [](Viewer &viewer) { viewer.nextView(); }},
      {Action::ToggleOrthographic, [](Viewer &viewer) { viewer.toggleOrthographic(); }},
      {Action::Home,
       [](Viewer &viewer) {
         if (viewer.home_)
           viewer.setCamera(*viewer.home_);
       }},
      {Action::ToggleHeatmap,
       [](Viewer &viewer) {
         viewer.setStyle(viewer.state_.style == Style::Heatmap ? viewer.styleBefore_ : Style::Heatmap);
       }},
      {Action::NextDevice, [](Viewer &viewer) { viewer.nextDevice(); }},
      {Action::EditFormat, [](Viewer &viewer) { viewer.isEditing_ = viewer.state_.showsPanel = true; }},
      {Action::PreviousPoint, [](Viewer &viewer) { viewer.nextPoint(-1); }},
      {Action::NextPoint, [](Viewer &viewer) { viewer.nextPoint(1); }},
      {Action::NextBrush, [](Viewer &viewer) { viewer.nextBrush(); }},
      {Action::BrushShape, [](Viewer &viewer) { viewer.toggleBrushShape(); }},
      {Action::BrushSmaller, [](Viewer &viewer) { viewer.resizeBrush(-1); }},
      {Action::BrushLarger, [](Viewer &viewer) { viewer.resizeBrush(1); }},
      {Action::BrushColour, [](Viewer &viewer) { viewer.takeBrushColour(); }},
      {Action::BrushCopy, [](Viewer &viewer) { viewer.copyUnderBrush(); }},
      {Action::UndoStroke, [](Viewer &viewer) { viewer.act(Undo{}); }},
      {Action::RedoStroke, [](Viewer &viewer) { viewer.act(Redo{}); }},
      {Action::PlayFrames, [](Viewer &viewer) { viewer.setPlaying(!viewer.isPlaying_); }},
      {Action::PreviousFrame, [](Viewer &viewer) { viewer.stepFrame(-1); }},
      {Action::NextFrame, [](Viewer &viewer) { viewer.stepFrame(1); }},
      {Action::SaveVolume, [](Viewer &viewer) { viewer.saveVolume(); }},
      {Action::CopyCamera, [](Viewer &viewer) { viewer.copyCamera(); }},
      {Action::Screenshot, [](Viewer &viewer) { viewer.writeScreenshot(); }},
      {Action::TogglePanel, [](Viewer &viewer) { viewer.state_.showsPanel = !viewer.state_.showsPanel; }},
      {Action::ToggleHelp, [](Viewer &viewer) { viewer.state_.showsHelp = !viewer.state_.showsHelp; }},
  };
  const bool isAgain = std::exchange(state_.isLeaving, false);
  log_.note("key " + std::string(keyKinds()[std::size_t(action)].key));
  motion_.press(action);
  if (action >= Action::StyleLit && action <= Action::StyleHeatmap)
    setStyle(static_cast<Style>(int(action) - int(Action::StyleLit)));
  if (const Row *const row = std::ranges::find(kRows, action, &Row::action); row != std::end(kRows))
    row->act(*this);
  if (action == Action::Escape)
    leave(isAgain);
}

/// Ends what has been begun last; closes the window if there is nothing, and the user `isSure`.
void Viewer::leave(bool isSure) {
  if (isLoading_ && scene_)
    stopLoading();
  else if (state_.showsHelp)
    state_.showsHelp = false;
  else if (isSure)
    state_.isClosing = true;
  else
    state_.isLeaving = true;
}

void Viewer::drag(double right, double down, bool isMoving) {
  state_.isLeaving = false;
  if (!camera_)
    return;
  if (isMoving) {
    const Camera camera = camera_->camera(options_.width, options_.height);
    const double pixel = shownHeight(camera, camera_->distance()) / camera.height;
    camera_->move(-right * pixel, down * pixel, 0);
  } else {
    // What is seen follows the mouse: in orbit because it turns, in flight because the head turns away.
    const double sign = state_.isFlying ? -1 : 1;
    camera_->turn(sign * right * kTurnOfPixel, -sign * down * kTurnOfPixel);
  }
  show();
}

void Viewer::zoom(double steps) {
  state_.isLeaving = false;
  if (!camera_)
    return;
  camera_->approach(std::pow(kNearerOfStep, steps));
  show();
}

void Viewer::resize(int width, int height) {
  if (width < 1 || height < 1 || (width == options_.width && height == options_.height))
    return;
  options_.width = width;
  options_.height = height;
  log_.note("size " + std::to_string(width) + "x" + std::to_string(height));
  show();
}

void Viewer::setStyle(Style style) {
  if (style == state_.style)
    return;
  if (style == Style::Heatmap)
    styleBefore_ = state_.style;
  state_.style = style;
  log_.tell("style " + std::string(toString(style)));
  show();
}

void Viewer::click(int column, int row) {
  state_.isLeaving = false;
  if (!isPlaced() || column < 0 || row < 0 || column >= options_.width || row >= options_.height)
    return;
  painter_.ask([this, column, row](const Shot &shot) {
    if (column < shot.camera.width && row < shot.camera.height)
      pick_.put(pick(shot, column, row));
  });
}

} // namespace voxc::view
