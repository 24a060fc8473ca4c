// Builds without GLFW and Dear ImGui.
#include "window/Window.h"

namespace voxc::view {

bool hasWindows() { return false; }

Expected<void> runWindow(const std::string &, ViewerOptions, SceneMaker, EventLog &) {
  return Error::environment("this build of voxc has no window, for GLFW or Dear ImGui was not there; voxc "
                            "render writes pictures without one");
}

} // namespace voxc::view
