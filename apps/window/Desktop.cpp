// GLFW and its windows.
#include "window/Desktop.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace voxc::view {
namespace {

/// What GLFW says of the last thing that failed.
std::string reason() {
  const char *text = nullptr;
  glfwGetError(&text);
  return text ? std::string(": ") + text : std::string();
}

} // namespace

Expected<Desktop> Desktop::open() {
  if (!glfwInit())
    return Error::environment("there is no display to open a window on" + reason() +
                              "; set DISPLAY, or let voxc render write a picture");
  Desktop desktop;
  if (!glfwVulkanSupported())
    return Error::environment(
        "there is no Vulkan loader to draw the window with; install one, such as libvulkan1");
  return desktop;
}

Desktop::~Desktop() {
  if (isOpen_)
    glfwTerminate();
}

void WindowDeleter::operator()(GLFWwindow *window) const { glfwDestroyWindow(window); }

Expected<WindowHandle> makeWindow(const std::string &title, int width, int height) {
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  WindowHandle window(glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr));
  if (!window)
    return Error::environment("cannot open a window" + reason());
  return window;
}

} // namespace voxc::view
