// What the keys of the viewer do: one table, from which the window, its help and the docs are made.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace voxc::view {

enum class Action {
  Forward,
  Back,
  Left,
  Right,
  Up,
  Down,
  TurnLeft,
  TurnRight,
  TurnUp,
  TurnDown,
  Nearer,
  Further,
  ToggleFly,
  Orbit,
  NextView,
  ToggleOrthographic,
  Home,
  StyleLit,
  StyleFlat,
  StyleAmbient,
  StyleNormals,
  StyleDepth,
  StyleHeatmap,
  ToggleHeatmap,
  NextDevice,
  EditFormat,
  PreviousPoint,
  NextPoint,
  NextBrush,
  BrushShape,
  BrushSmaller,
  BrushLarger,
  BrushColour,
  BrushCopy,
  UndoStroke,
  RedoStroke,
  PlayFrames,
  PreviousFrame,
  NextFrame,
  SaveVolume,
  CopyCamera,
  Screenshot,
  TogglePanel,
  ToggleHelp,
  Escape,
};

struct KeyKind {
  Action action;
  std::string_view key; ///< As it is printed on a keyboard: "W", "Left", "F1".
  std::string_view summary;
  bool isHeld; ///< It acts for as long as it is down.
};

/// All keys, in the order of the enumeration.
std::span<const KeyKind> keyKinds();

/// What the mouse does; `key` names the button.
struct MouseKind {
  std::string_view button, summary;
};
std::span<const MouseKind> mouseKinds();

/// The action of the key of this name; nothing if it has none.
std::optional<Action> actionOf(std::string_view key);

/// The table in lines, two blanks before each: "  W   fly forwards".
std::string keysHelp();

} // namespace voxc::view
