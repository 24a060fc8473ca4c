// Pictures of the lookups that each ray took, with a legend.
#include "Colour.h"
#include "DigitFont.h"

#include "voxc/Trace/Picture.h"

#include <algorithm>
#include <string>

namespace voxc {
namespace {

/// From few lookups to many; each is brighter than the one before, so that the map also reads in grey.
constexpr Colour kScale[] = {
    {0.03f, 0.03f, 0.12f}, {0.22f, 0.09f, 0.45f}, {0.58f, 0.15f, 0.48f},
    {0.90f, 0.36f, 0.28f}, {0.99f, 0.70f, 0.25f}, {0.99f, 0.98f, 0.78f},
};

constexpr std::uint32_t kBackdrop = 0xff181818;
constexpr std::uint32_t kInk = 0xffffffff;

/// The colour at `amount` in [0, 1] of the scale.
Colour scaleColour(float amount) {
  float place = amount * (std::size(kScale) - 1);
  std::size_t below = std::min(static_cast<std::size_t>(place), std::size(kScale) - 2);
  return mix(kScale[below], kScale[below + 1], place - static_cast<float>(below));
}

/// The fewest and the most lookups of any ray.
struct StepRange {
  std::uint32_t low = 0;
  std::uint32_t high = 0;

  std::uint32_t pixel(std::uint32_t steps) const {
    float amount = high > low ? static_cast<float>(steps - low) / static_cast<float>(high - low) : 0;
    return packColour(scaleColour(amount));
  }
};

StepRange stepRange(std::span<const Hit> hits) {
  if (hits.empty())
    return {};
  auto [low, high] = std::ranges::minmax(hits, {}, &Hit::steps);
  return {low.steps, high.steps};
}

/// A strip at the bottom left: the lowest number, the colours from low to high, the highest number. A picture
/// too small for it goes without.
void drawLegend(Picture &picture, const StepRange &range) {
  int scale = std::max(2, picture.height / 240);
  int margin = 2 * scale;
  int bar = 48 * scale;
  std::string low = std::to_string(range.low);
  std::string high = std::to_string(range.high);
  int lowWidth = textWidth(low, scale);
  int width = lowWidth + bar + textWidth(high, scale) + 4 * margin;
  int height = kGlyphHeight * scale + 2 * margin;
  if (width > picture.width || 2 * height > picture.height)
    return;
  int top = picture.height - height;
  int barLeft = lowWidth + 2 * margin;
  fillRectangle(picture, 0, top, width, height, kBackdrop);
  drawDigits(picture, low, margin, top + margin, scale, kInk);
  drawDigits(picture, high, barLeft + bar + margin, top + margin, scale, kInk);
  for (int column = 0; column < bar; ++column) {
    float amount = static_cast<float>(column) / static_cast<float>(bar - 1);
    fillRectangle(picture, barLeft + column, top + margin, 1, kGlyphHeight * scale,
                  packColour(scaleColour(amount)));
  }
}

} // namespace

Picture heatmap(std::span<const Hit> hits, int width, int height) {
  Picture picture{width, height, {}};
  picture.pixels.resize(std::size_t(width) * std::size_t(height), packColour(kScale[0]));
  std::size_t count = std::min(picture.pixels.size(), hits.size());
  StepRange range = stepRange(hits.first(count));
  std::ranges::transform(hits.first(count), picture.pixels.begin(),
                         [&](const Hit &hit) { return range.pixel(hit.steps); });
  drawLegend(picture, range);
  return picture;
}

} // namespace voxc
