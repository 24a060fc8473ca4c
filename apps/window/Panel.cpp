// The panel, by Dear ImGui.
#include "window/Panel.h"

#include "window/Chart.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <utility>

namespace voxc::view {
namespace {

constexpr float kWidth = 330, kMargin = 8;

void wrapped(const std::string &text) {
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

/// A window that is looked at alone.
constexpr ImGuiWindowFlags kNote = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_AlwaysAutoResize |
                                   ImGuiWindowFlags_NoSavedSettings;

void heading(const char *text) {
  ImGui::Spacing();
  ImGui::TextDisabled("%s", text);
  ImGui::Separator();
}

} // namespace

void Panel::draw(Viewer &viewer) {
  width_ = height_ = 0;
  const float before = std::exchange(length_, 0);
  hasPopup_ = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
  const bool wantsText = viewer.takeEditing();
  if (wantsText)
    isWriting_ = true;
  if (viewer.state().showsPanel) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({kMargin, kMargin});
    ImGui::SetNextWindowSizeConstraints({kWidth, 0}, {kWidth, window.y - 2 * kMargin});
    ImGui::SetNextWindowBgAlpha(0.85f);
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoNav | ImGuiWindowFlags_AlwaysAutoResize |
                                        ImGuiWindowFlags_NoSavedSettings;
    if (ImGui::Begin("voxc view", nullptr, kFlags & ~ImGuiWindowFlags_NoScrollbar)) {
      if (wantsText)
        ImGui::SetKeyboardFocusHere();
      drawFormat(viewer);
      drawScene(viewer);
      drawFrames(viewer);
      drawPicture(viewer);
      drawPick(viewer);
      drawChart(viewer);
      length_ = ImGui::GetCursorPosY();
    }
    const ImVec2 size = ImGui::GetWindowSize();
    width_ = size.x + kMargin;
    height_ = size.y + kMargin;
    ImGui::End();
  } else {
    isWriting_ = false;
  }
  if (viewer.state().showsHelp)
    drawHelp();
  if (viewer.state().isLeaving)
    drawQuestion();
  isSettling_ = length_ != before;
}

bool Panel::closeList() { return closesList_ = hasPopup_; }

bool Panel::covers(double column, double row) const {
  // ImGui itself knows only where the mouse was when the last frame was drawn.
  return hasPopup_ || (column < width_ && row < height_);
}

void Panel::drawFormat(Viewer &viewer) {
  if (shown_ != viewer.state().format)
    text_ = shown_ = viewer.state().format;
  ImGui::TextDisabled("format and passes (T)");
  ImGui::SetNextItemWidth(-1);
  const bool isEntered = ImGui::InputText(
      "##format", &text_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  if (ImGui::IsItemActivated())
    viewer.startedWriting();
  if (ImGui::IsItemDeactivated())
    viewer.stoppedWriting();
  if (ImGui::IsItemActive() || ImGui::IsItemDeactivated())
    isWriting_ = ImGui::IsItemActive();
  if (isEntered)
    viewer.load(text_);
}

void Panel::drawScene(Viewer &viewer) {
  const ViewerState &state = viewer.state();
  if (ImGui::CalcTextSize(state.format.c_str()).x > kWidth - 2 * kMargin)
    wrapped(state.format);
  if (!state.work.empty())
    ImGui::TextColored({1, 0.85f, 0.4f, 1}, "loading: %s", state.work.c_str());
  if (!state.error.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, {1, 0.5f, 0.45f, 1});
    wrapped(state.error);
    ImGui::PopStyleColor();
  }
  if (!state.size.empty())
    wrapped(state.size);
  ImGui::SetNextItemWidth(-1);
  const bool closesList = std::exchange(closesList_, false);
  if (ImGui::BeginCombo("##device", state.device.empty() ? "device" : state.device.c_str())) {
    if (closesList)
      ImGui::CloseCurrentPopup();
    for (const std::string &device : viewer.options().devices)
      if (ImGui::Selectable(device.c_str(), device == state.device))
        viewer.useDevice(device);
    ImGui::EndCombo();
  }
}

void Panel::drawFrames(Viewer &viewer) {
  const ViewerState &state = viewer.state();
  if (state.frames < 2)
    return;
  heading(viewer.isPlaying() ? "frames, playing (Space)" : "frames (Space plays)");
  const std::string text = "%d of " + std::to_string(state.frames);
  int number = int(state.frame) + 1;
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderInt("##frame", &number, 1, int(state.frames), text.c_str(), ImGuiSliderFlags_AlwaysClamp))
    viewer.showFrame(std::size_t(number) - 1);
}

void Panel::drawPicture(Viewer &viewer) {
  const ViewerState &state = viewer.state();
  heading("picture");
  constexpr int kInRow = 3;
  for (const StyleKind &kind : styleKinds()) {
    const int number = int(&kind - styleKinds().data());
    if (number % kInRow != 0)
      ImGui::SameLine(kWidth / kInRow * float(number % kInRow));
    if (ImGui::RadioButton(std::string(toString(kind.style)).c_str(), state.style == kind.style))
      viewer.setStyle(kind.style);
  }
  ImGui::Text("%s", state.picture.c_str());
  ImGui::SameLine();
  ImGui::TextDisabled("%s", state.isFlying ? "fly" : "orbit");
}

void Panel::drawPick(const Viewer &viewer) {
  if (!viewer.state().brush.empty()) {
    heading("brush");
    wrapped(viewer.state().brush);
  }
  heading("click");
  if (viewer.state().picked.empty())
    ImGui::TextDisabled("a click shows the voxel");
  else
    wrapped(viewer.state().picked);
}

void Panel::drawChart(Viewer &viewer) {
  const SearchPoints &search = viewer.options().search;
  if (search.points.empty())
    return;
  heading(("search of " + search.model + " on " + search.device).c_str());
  if (const auto chosen = view::drawChart(search, viewer.state().format))
    viewer.load(search.points[*chosen].text);
}

void Panel::drawHelp() {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({window.x - kMargin, kMargin}, ImGuiCond_Always, {1, 0});
  ImGui::SetNextWindowBgAlpha(0.85f);
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {4, 0});
  ImGui::Begin("keys", nullptr, kNote);
  if (ImGui::BeginTable("keys", 2)) {
    const auto row = [](std::string_view name, std::string_view summary) {
      ImGui::TableNextColumn();
      ImGui::TextColored({1, 0.85f, 0.4f, 1}, "%.*s", int(name.size()), name.data());
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(summary.data(), summary.data() + summary.size());
    };
    for (const KeyKind &kind : keyKinds())
      row(kind.key, kind.summary);
    for (const MouseKind &kind : mouseKinds())
      row(kind.button, kind.summary);
    ImGui::EndTable();
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

void Panel::drawQuestion() {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({window.x / 2, window.y - kMargin}, ImGuiCond_Always, {0.5f, 1});
  ImGui::Begin("closing", nullptr, kNote);
  ImGui::TextColored({1, 0.85f, 0.4f, 1}, "Escape once more closes the window");
  ImGui::End();
}

} // namespace voxc::view
