// The window for who does not link it: another program, the same driver with the window in it, takes over. So
// nothing but `voxc view` loads what a window needs: GLFW, X11 and the Vulkan loader.
#include "window/Window.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <unistd.h>
#include <vector>

namespace voxc::view {
namespace {

constexpr const char *kProgram = "voxc-viewer";

/// Beside this program, or where it is installed; empty if it is not there.
std::filesystem::path findProgram() {
  std::error_code failure;
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", failure).parent_path();
  for (const std::filesystem::path &place : {folder, folder / ".." / "libexec" / "voxc"})
    if (std::filesystem::exists(place / kProgram, failure))
      return place / kProgram;
  return {};
}

/// The arguments of this process as they were given.
std::vector<std::string> ownArguments() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::vector<std::string> arguments;
  for (std::string argument; std::getline(file, argument, '\0');)
    arguments.push_back(argument);
  return arguments;
}

} // namespace

bool hasWindows() { return !findProgram().empty(); }

// As with a window, which takes them over. NOLINTNEXTLINE(performance-unnecessary-value-param)
Expected<void> runWindow(const std::string &, ViewerOptions, SceneMaker, EventLog &) {
  const std::filesystem::path program = findProgram();
  if (program.empty())
    return Error::environment("there is no " + std::string(kProgram) +
                              " beside voxc, which has the window: it is built where GLFW and Dear ImGui are "
                              "at hand; voxc render writes pictures without one");
  std::vector<std::string> arguments = ownArguments();
  std::vector<char *> pointers;
  pointers.reserve(arguments.size() + 1);
  for (std::string &argument : arguments)
    pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  ::execv(program.c_str(), pointers.data());
  return Error::environment("cannot start '" + program.native() + "': " + std::strerror(errno));
}

} // namespace voxc::view
