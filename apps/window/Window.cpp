// The window's loop: input to the viewer, what it shows to the screen.
#include "window/Window.h"

#include "common/Interrupt.h"
#include "window/Desktop.h"
#include "window/Panel.h"
#include "window/Presenter.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <algorithm>

namespace voxc::view {
namespace {

/// Seconds from one frame to the next while something moves, and between looks at nothing.
constexpr double kFrame = 1.0 / 60, kIdle = 0.25;

/// ImGui takes so many frames until what an input changed is drawn.
constexpr int kFramesOfInput = 3;

/// A button that was released within so many pixels of where it went down was a click.
constexpr double kClick = 4;

/// Keys whose name is not the character on them.
constexpr std::pair<int, std::string_view> kNamedKeys[] = {
    {GLFW_KEY_LEFT, "Left"},
    {GLFW_KEY_RIGHT, "Right"},
    {GLFW_KEY_UP, "Up"},
    {GLFW_KEY_DOWN, "Down"},
    {GLFW_KEY_TAB, "Tab"},
    {GLFW_KEY_ESCAPE, "Escape"},
    {GLFW_KEY_F1, "F1"},
    {GLFW_KEY_F2, "F2"},
    {GLFW_KEY_SPACE, "Space"},
    {GLFW_KEY_PAGE_UP, "PageUp"},
    {GLFW_KEY_PAGE_DOWN, "PageDown"},
};

/// The action of a key by its place: the letter that it has on a keyboard of the United States.
std::optional<Action> actionOfKey(int key) {
  const auto *const named = std::ranges::find(kNamedKeys, key, &std::pair<int, std::string_view>::first);
  if (named != std::end(kNamedKeys))
    return actionOf(named->second);
  const char name = char(key);
  return key > ' ' && key < 128 ? actionOf({&name, 1}) : std::nullopt;
}

class Window {
public:
  Window(WindowHandle handle, std::unique_ptr<Presenter> presenter, ViewerOptions options, SceneMaker maker,
         EventLog &log)
      : handle_(std::move(handle)), presenter_(std::move(presenter)),
        viewer_(std::move(options), std::move(maker), log, [] { glfwPostEmptyEvent(); }) {
    listen();
  }

  Expected<void> run();

private:
  void listen();
  template <auto method, typename... Arguments> static void hear(GLFWwindow *handle, Arguments... arguments) {
    (static_cast<Window *>(glfwGetWindowUserPointer(handle))->*method)(arguments...);
  }
  void onKey(int key, int code, int action, int modifiers);
  void onButton(int button, int action, int modifiers);
  void onMove(double column, double row);
  void onScroll(double right, double up);
  void onFocus(int isFocused);
  void onSize(int width, int height);
  void onRefresh() { wake(); }
  void onCharacter(unsigned character);
  void releaseLate();
  /// Something but the picture may look different now. What only moves the camera is seen with the next
  /// picture: a frame before that would take time from it.
  void wake() { frames_ = kFramesOfInput; }

  /// Where a place in the window lies in the picture: on scaled desktops a unit there can be several pixels.
  glm::dvec2 toPixels(glm::dvec2 place) const;
  void stroke(bool isFirst);

  /// Whether the button that is down edits.
  bool strokes() const { return viewer_.isBrushing() && button_ == GLFW_MOUSE_BUTTON_LEFT; }

  struct Released {
    int key, code, modifiers;
  };

  bool isClosing() const;
  Expected<void> draw();

  WindowHandle handle_;
  std::unique_ptr<Presenter> presenter_;
  Panel panel_;
  Viewer viewer_;
  int frames_ = kFramesOfInput;    ///< That are to be drawn.
  int button_ = -1;                ///< That went down on the picture; -1: none.
  std::vector<Released> released_; ///< Since the last frame.
  glm::dvec2 mouse_{}, pressed_{}; ///< In the window's own coordinates.
  bool isDragging_ = false;
  bool isPictureNew_ = false; ///< It was not presented yet.
};

void Window::listen() {
  GLFWwindow *const handle = handle_.get();
  glfwSetWindowUserPointer(handle, this);
  glfwSetKeyCallback(handle, hear<&Window::onKey, int, int, int, int>);
  glfwSetMouseButtonCallback(handle, hear<&Window::onButton, int, int, int>);
  glfwSetCursorPosCallback(handle, hear<&Window::onMove, double, double>);
  glfwSetScrollCallback(handle, hear<&Window::onScroll, double, double>);
  glfwSetWindowFocusCallback(handle, hear<&Window::onFocus, int>);
  glfwSetFramebufferSizeCallback(handle, hear<&Window::onSize, int, int>);
  glfwSetWindowRefreshCallback(handle, hear<&Window::onRefresh>);
  glfwSetCharCallback(handle, hear<&Window::onCharacter, unsigned>);
}

void Window::onKey(int key, int code, int event, int modifiers) {
  // ImGui looks at keys once a frame: one that is up again before that must stay down for it until then.
  if (event == GLFW_RELEASE)
    released_.push_back({key, code, modifiers});
  else
    ImGui_ImplGlfw_KeyCallback(handle_.get(), key, code, event, modifiers);
  const std::optional<Action> action = actionOfKey(key);
  if (panel_.isWriting() || (action && !keyKinds()[std::size_t(*action)].isHeld))
    wake();
  if (!action)
    return;
  if (event == GLFW_RELEASE)
    viewer_.release(*action);
  else if (event == GLFW_PRESS && !panel_.isWriting() && !(modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT)) &&
           !(*action == Action::Escape && panel_.closeList()))
    viewer_.press(*action);
}

void Window::releaseLate() {
  for (const Released &key : std::exchange(released_, {}))
    ImGui_ImplGlfw_KeyCallback(handle_.get(), key.key, key.code, GLFW_RELEASE, key.modifiers);
}

glm::dvec2 Window::toPixels(glm::dvec2 place) const {
  glm::ivec2 window{}, picture{};
  glfwGetWindowSize(handle_.get(), &window.x, &window.y);
  glfwGetFramebufferSize(handle_.get(), &picture.x, &picture.y);
  return place * glm::dvec2(picture) / glm::dvec2(glm::max(window, 1));
}

void Window::stroke(bool isFirst) {
  const glm::ivec2 pixel = toPixels(mouse_);
  viewer_.stroke(pixel.x, pixel.y, isFirst);
}

void Window::onButton(int button, int event, int modifiers) {
  wake();
  ImGui_ImplGlfw_MouseButtonCallback(handle_.get(), button, event, modifiers);
  if (event == GLFW_PRESS && !panel_.covers(mouse_.x, mouse_.y)) {
    button_ = button;
    pressed_ = mouse_;
    isDragging_ = false;
    if (strokes())
      stroke(true);
  } else if (event == GLFW_RELEASE && button == button_) {
    if (!isDragging_ && button == GLFW_MOUSE_BUTTON_LEFT && !strokes()) {
      const glm::ivec2 pixel = toPixels(pressed_);
      viewer_.click(pixel.x, pixel.y);
    }
    button_ = -1;
  }
}

void Window::onMove(double column, double row) {
  const glm::dvec2 place(column, row), before = isDragging_ ? mouse_ : pressed_;
  if (panel_.covers(column, row) || panel_.covers(mouse_.x, mouse_.y))
    wake();
  mouse_ = place;
  if (button_ < 0)
    return;
  isDragging_ = isDragging_ || glm::distance(place, pressed_) >= kClick;
  if (strokes())
    stroke(false);
  else if (isDragging_) {
    const glm::dvec2 way = toPixels(place - before);
    viewer_.drag(way.x, way.y, button_ != GLFW_MOUSE_BUTTON_LEFT);
  }
}

void Window::onScroll(double right, double up) {
  ImGui_ImplGlfw_ScrollCallback(handle_.get(), right, up);
  if (panel_.covers(mouse_.x, mouse_.y))
    wake();
  else
    viewer_.zoom(up);
}

void Window::onFocus(int isFocused) {
  ImGui_ImplGlfw_WindowFocusCallback(handle_.get(), isFocused);
  wake();
  if (!isFocused)
    viewer_.releaseKeys();
}

void Window::onSize(int width, int height) {
  viewer_.resize(width, height);
  wake();
}

void Window::onCharacter(unsigned character) {
  ImGui_ImplGlfw_CharCallback(handle_.get(), character);
  wake();
}

bool Window::isClosing() const {
  return viewer_.state().isClosing || glfwWindowShouldClose(handle_.get()) || tool::catchInterrupts();
}

Expected<void> Window::draw() {
  presenter_->beginFrame();
  ImGui::NewFrame();
  panel_.draw(viewer_);
  ImGui::Render();
  releaseLate();
  if (const Picture *const picture = viewer_.takePicture()) {
    presenter_->setPicture(*picture);
    isPictureNew_ = true;
  }
  const auto presented = VOXC_TRY(presenter_->present(ImGui::GetDrawData()));
  if (!presented)
    return {};
  --frames_;
  if (panel_.isSettling())
    frames_ = std::max(frames_, 1);
  if (std::exchange(isPictureNew_, false))
    viewer_.presented();
  if (const std::optional<std::string> text = viewer_.takeCopied())
    glfwSetClipboardString(handle_.get(), text->c_str());
  return {};
}

Expected<void> Window::run() {
  double drawn = glfwGetTime() - kFrame, advanced = drawn;
  while (!isClosing()) {
    const bool isBusy = frames_ > 0 || viewer_.isMoving();
    const double left = isBusy ? drawn + kFrame - glfwGetTime() : kIdle;
    if (left > 0)
      glfwWaitEventsTimeout(left);
    else
      glfwPollEvents();
    const double now = glfwGetTime();
    if (viewer_.advance(now - std::exchange(advanced, now)))
      frames_ = std::max(frames_, 1);
    if (viewer_.failure())
      return *viewer_.failure();
    if (frames_ == 0 || now < drawn + kFrame)
      continue;
    drawn = now;
    VOXC_TRY(draw());
  }
  return tool::catchInterrupts() ? Expected<void>(Error::interrupted()) : Expected<void>();
}

/// ImGui for as long as this lives.
struct ImGuiContextOwner {
  ImGuiContextOwner() {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::StyleColorsDark();
    ImGui::GetStyle().WindowRounding = 6;
    ImGui::GetStyle().FrameRounding = 3;
  }
  ~ImGuiContextOwner() { ImGui::DestroyContext(); }
};

} // namespace

bool hasWindows() { return true; }

Expected<void> runWindow(const std::string &title, ViewerOptions options, SceneMaker maker, EventLog &log) {
  tool::catchInterrupts();
  const auto desktop = VOXC_TRY(Desktop::open());
  auto handle = VOXC_TRY(makeWindow(title, options.width, options.height));
  const ImGuiContextOwner context;
  auto presenter = VOXC_TRY(Presenter::create(handle.get()));
  log.tell("window " + std::to_string(options.width) + "x" + std::to_string(options.height) + " on " +
           presenter->deviceName());
  return Window(std::move(handle), std::move(presenter), std::move(options), std::move(maker), log).run();
}

} // namespace voxc::view
