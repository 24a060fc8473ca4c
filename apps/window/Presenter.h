// Brings a picture and what ImGui draws over it to a window, by Vulkan.
#pragma once

#include "voxc/Render/Picture.h"
#include "voxc/Support/Error.h"

#include <memory>
#include <string>

struct GLFWwindow;
struct ImDrawData;

namespace voxc::view {

class Presenter {
public:
  /// For a window made for Vulkan, which must outlive it; there must be a context of ImGui. Error:
  /// `Environment`, no device can present on the window, or it fails.
  static Expected<std::unique_ptr<Presenter>> create(GLFWwindow *window);
  ~Presenter();

  /// The device that presents.
  const std::string &deviceName() const;
  /// Shows this picture from the next frame on, at the top left, as it is.
  void setPicture(const Picture &picture);
  /// To be called before `ImGui::NewFrame`.
  void beginFrame();
  /// Presents a frame; true if it came to the screen, false if the window just changed its size or has none:
  /// try again. Error: `Environment`, the device failed.
  Expected<bool> present(ImDrawData *drawData);

private:
  struct State;
  explicit Presenter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

} // namespace voxc::view
