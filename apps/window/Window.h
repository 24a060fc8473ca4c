// The window of the viewer.
#pragma once

#include "view/Viewer.h"

#include <string>

namespace voxc::view {

/// Whether this build has windows (the option VOXC_VIEW, and GLFW and Dear ImGui at hand).
bool hasWindows();

/// Opens a window and shows what a viewer shows, until the user closes it or an interrupt comes. Must be
/// called on the main thread. Errors: `Environment`, this build has no windows, there is no display, or no
/// Vulkan device that can present on it.
Expected<void> runWindow(const std::string &title, ViewerOptions options, SceneMaker maker, EventLog &log);

} // namespace voxc::view
