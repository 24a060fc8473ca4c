// A window of the desktop, by GLFW.
#pragma once

#include "voxc/Support/Error.h"

#include <memory>
#include <string>

struct GLFWwindow;

namespace voxc::view {

/// GLFW for as long as one of these lives.
class Desktop {
public:
  /// Error: `Environment`, there is no display.
  static Expected<Desktop> open();
  ~Desktop();
  Desktop(Desktop &&other) noexcept : isOpen_(std::exchange(other.isOpen_, false)) {}
  Desktop &operator=(Desktop &&) = delete;

private:
  Desktop() = default;
  bool isOpen_ = true;
};

struct WindowDeleter {
  void operator()(GLFWwindow *window) const;
};
using WindowHandle = std::unique_ptr<GLFWwindow, WindowDeleter>;

/// A window without a picture, for Vulkan. Error: `Environment`.
Expected<WindowHandle> makeWindow(const std::string &title, int width, int height);

} // namespace voxc::view
