// The table of keys.
#include "view/Keys.h"

#include <algorithm>

namespace voxc::view {
namespace {

constexpr KeyKind kKeys[] = {
    {Action::Forward, "W", "move forwards", true},
    {Action::Back, "S", "move backwards", true},
    {Action::Left, "A", "move to the left", true},
    {Action::Right, "D", "move to the right", true},
    {Action::Up, "E", "move up", true},
    {Action::Down, "Q", "move down", true},
    {Action::TurnLeft, "Left", "turn to the left", true},
    {Action::TurnRight, "Right", "turn to the right", true},
    {Action::TurnUp, "Up", "turn upwards", true},
    {Action::TurnDown, "Down", "turn downwards", true},
    {Action::Nearer, "=", "go nearer to the point looked at", true},
    {Action::Further, "-", "go further away from it", true},
    {Action::ToggleFly, "F", "fly: turn about the eye; or again orbit: about the point looked at", false},
    {Action::Orbit, "O", "look at the voxel that was clicked, and orbit around it", false},
    {Action::NextView, "V", "next view: iso, front, top, inside", false},
    {Action::ToggleOrthographic, "X", "parallel rays, or again perspective", false},
    {Action::Home, "R", "return to the camera of the beginning", false},
    {Action::StyleLit, "1", "style lit", false},
    {Action::StyleFlat, "2", "style flat", false},
    {Action::StyleAmbient, "3", "style ao", false},
    {Action::StyleNormals, "4", "style normals", false},
    {Action::StyleDepth, "5", "style depth", false},
    {Action::StyleHeatmap, "6", "style heatmap", false},
    {Action::ToggleHeatmap, "H", "heat map of lookups, or again the style before it", false},
    {Action::NextDevice, "G", "trace on the next device", false},
    {Action::EditFormat, "T", "write another format; Enter loads it", false},
    {Action::PreviousPoint, "[", "load the next smaller format of the search's frontier", false},
    {Action::NextPoint, "]", "load the next larger format of the search's frontier", false},
    {Action::NextBrush, "B", "next brush: add, erase, paint, paste what was copied, or none", false},
    {Action::BrushShape, "N", "a brush of a box, or again of a sphere", false},
    {Action::BrushSmaller, ",", "a smaller brush", false},
    {Action::BrushLarger, ".", "a larger brush", false},
    {Action::BrushColour, "K", "take the colour of the voxel that was clicked", false},
    {Action::BrushCopy, "J", "copy what the brush covers at the voxel that was clicked", false},
    {Action::UndoStroke, "Z", "undo the last stroke of a brush", false},
    {Action::RedoStroke, "Y", "redo it", false},
    {Action::PlayFrames, "Space", "play the frames of an animation, or again stop", false},
    {Action::PreviousFrame, "PageUp", "the frame before", false},
    {Action::NextFrame, "PageDown", "the next frame", false},
    {Action::SaveVolume, "F2", "write the volume as it is to a .hvx file", false},
    {Action::CopyCamera, "C", "copy the camera as options, and print it", false},
    {Action::Screenshot, "P", "write the picture as a PNG", false},
    {Action::TogglePanel, "Tab", "show or hide the panel", false},
    {Action::ToggleHelp, "F1", "show or hide the keys", false},
    {Action::Escape, "Escape", "leave the text, end loading, hide the keys; or else, twice, close the window",
     false},
};

constexpr MouseKind kMouse[] = {
    {"left drag", "turn; or with a brush, edit"},
    {"right drag", "move sideways and up"},
    {"wheel", "go nearer or further"},
    {"left click", "show the voxel there, and what the oracle says of it"},
};

void addLine(std::string &text, std::string_view name, std::string_view summary) {
  constexpr std::size_t kColumn = 12;
  text += "  " + std::string(name) + std::string(kColumn - std::min(name.size(), kColumn - 1), ' ') +
          std::string(summary) + "\n";
}

} // namespace

std::span<const KeyKind> keyKinds() { return kKeys; }
std::span<const MouseKind> mouseKinds() { return kMouse; }

std::optional<Action> actionOf(std::string_view key) {
  const auto *const row = std::ranges::find(kKeys, key, &KeyKind::key);
  return row == std::end(kKeys) ? std::nullopt : std::optional(row->action);
}

std::string keysHelp() {
  std::string text;
  for (const KeyKind &kind : kKeys)
    addLine(text, kind.key, kind.summary);
  for (const MouseKind &kind : kMouse)
    addLine(text, kind.button, kind.summary);
  return text;
}

} // namespace voxc::view
