// Pictures of numbers, such as the lookups that each ray took, with a legend.
#include "Colour.h"
#include "Font.h"

#include "voxc/Render/Picture.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace voxc {
namespace {

/// From few to many; each is brighter than the one before, so that the map also reads in grey.
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

/// The least and the greatest number of a picture, and which of them is bright.
struct Scale {
  float low = 0;
  float high = 0;
  bool isFalling = false;

  std::uint32_t pixel(float value) const { return shade(high > low ? (value - low) / (high - low) : 0); }
  /// The pixel so far from low to high.
  std::uint32_t shade(float amount) const { return packColour(scaleColour(isFalling ? 1 - amount : amount)); }
};

Scale scaleOf(std::span<const float> values, bool isFalling) {
  Scale scale{0, 0, isFalling};
  bool isFirst = true;
  for (const float value : values) {
    if (!std::isfinite(value))
      continue;
    scale.low = isFirst ? value : std::min(scale.low, value);
    scale.high = isFirst ? value : std::max(scale.high, value);
    isFirst = false;
  }
  return scale;
}

std::string wholeNumber(float value) { return std::to_string(std::llround(value)); }

/// A strip at the bottom left: the lowest number, the colours from low to high, the highest number, and the
/// unit of both. A picture too small for it goes without.
void drawLegend(Picture &picture, const Scale &scale, std::string_view unit) {
  int cell = std::max(2, picture.height / 240);
  int margin = 2 * cell;
  int bar = 48 * cell;
  std::string low = wholeNumber(scale.low);
  std::string high = wholeNumber(scale.high) + " " + std::string(unit);
  int lowWidth = textWidth(low, cell);
  int width = lowWidth + bar + textWidth(high, cell) + 4 * margin;
  int height = kGlyphHeight * cell + 2 * margin;
  if (width > picture.width || 2 * height > picture.height)
    return;
  int top = picture.height - height;
  int barLeft = lowWidth + 2 * margin;
  fillRectangle(picture, 0, top, width, height, kBackdrop);
  drawText(picture, low, margin, top + margin, cell, kInk);
  drawText(picture, high, barLeft + bar + margin, top + margin, cell, kInk);
  for (int column = 0; column < bar; ++column) {
    float amount = static_cast<float>(column) / static_cast<float>(bar - 1);
    fillRectangle(picture, barLeft + column, top + margin, 1, kGlyphHeight * cell, scale.shade(amount));
  }
}

} // namespace

Picture mapPicture(std::span<const float> values, int width, int height, std::string_view unit,
                   bool isFalling) {
  Picture picture{width, height, {}};
  picture.pixels.resize(std::size_t(width) * std::size_t(height), kBackdrop);
  std::size_t count = std::min(picture.pixels.size(), values.size());
  const Scale scale = scaleOf(values.first(count), isFalling);
  for (std::size_t i = 0; i < count; ++i)
    if (std::isfinite(values[i]))
      picture.pixels[i] = scale.pixel(values[i]);
  drawLegend(picture, scale, unit);
  return picture;
}

Picture heatmap(std::span<const Hit> hits, int width, int height) {
  std::vector<float> steps(hits.size());
  std::ranges::transform(hits, steps.begin(), [](const Hit &hit) { return static_cast<float>(hit.steps); });
  return mapPicture(steps, width, height, "LOOKUPS A RAY");
}

} // namespace voxc
