// Charts, by the lines and circles of Dear ImGui.
#include "window/Chart.h"

#include "view/SearchChart.h"

#include <imgui.h>

#include <algorithm>

namespace voxc::view {
namespace {

constexpr float kHeight = 170, kBelow = 18;
constexpr double kReach = 8;

constexpr ImU32 kGrid = IM_COL32(255, 255, 255, 30), kText = IM_COL32(190, 195, 205, 255),
                kLine = IM_COL32(110, 180, 255, 255), kLeading = IM_COL32(110, 180, 255, 255),
                kBeaten = IM_COL32(150, 150, 150, 160), kShown = IM_COL32(255, 217, 102, 255);

ImVec2 at(const ImVec2 &corner, const glm::dvec2 &place) {
  return {corner.x + float(place.x), corner.y + float(place.y)};
}

void drawTicks(ImDrawList &list, const SearchChart &chart, const ImVec2 &corner, float width) {
  for (const Tick &tick : chart.speedTicks()) {
    const float y = corner.y + float(tick.place);
    list.AddLine({corner.x, y}, {corner.x + width, y}, kGrid);
    list.AddText({corner.x + 2, std::max(corner.y, y - ImGui::GetTextLineHeight())}, kText,
                 tick.text.c_str());
  }
  for (const Tick &tick : chart.sizeTicks()) {
    const float x = corner.x + float(tick.place), half = ImGui::CalcTextSize(tick.text.c_str()).x / 2;
    const float left = std::clamp(x - half, corner.x, std::max(corner.x, corner.x + width - 2 * half));
    list.AddLine({x, corner.y}, {x, corner.y + kHeight}, kGrid);
    list.AddText({left, corner.y + kHeight + 2}, kText, tick.text.c_str());
  }
}

void drawPoints(ImDrawList &list, const SearchChart &chart, const SearchPoints &search, const ImVec2 &corner,
                const std::string &shown) {
  for (std::size_t i = 1; i < chart.frontier().size(); ++i)
    list.AddLine(at(corner, chart.frontier()[i - 1]), at(corner, chart.frontier()[i]), kLine, 1.5f);
  for (const bool isLeading : {false, true})
    for (std::size_t i = 0; i < search.points.size(); ++i)
      if (search.points[i].isLeading == isLeading)
        list.AddCircleFilled(at(corner, chart.places()[i]), isLeading ? 4.5f : 3,
                             isLeading ? kLeading : kBeaten);
  if (const auto i = search.find(shown))
    list.AddCircle(at(corner, chart.places()[*i]), 8, kShown, 0, 2);
}

} // namespace

std::optional<std::size_t> drawChart(const SearchPoints &search, const std::string &shown) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const SearchChart chart(search, width, kHeight);
  const bool isClicked = ImGui::InvisibleButton("chart", {width, kHeight + kBelow});
  ImDrawList &list = *ImGui::GetWindowDrawList();
  drawTicks(list, chart, corner, width);
  drawPoints(list, chart, search, corner, shown);
  ImGui::TextDisabled("million rays a second, by bytes");
  if (!ImGui::IsItemHovered() && !isClicked &&
      !ImGui::IsMouseHoveringRect(corner, {corner.x + width, corner.y + kHeight}))
    return std::nullopt;
  const ImVec2 mouse = ImGui::GetMousePos();
  const auto near = chart.nearest({mouse.x - corner.x, mouse.y - corner.y}, kReach);
  if (near) {
    const SearchPoint &point = search.points[*near];
    ImGui::SetTooltip("%s\n%.4g MiB, %.3g million rays a second", point.text.c_str(), point.bytes / (1 << 20),
                      point.mraysPerS);
  }
  return isClicked ? near : std::nullopt;
}

} // namespace voxc::view
