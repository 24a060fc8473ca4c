// Lines "name=value" of ImageJ.
#include "Input/Dense/ImageJ.h"

#include "Support/Text.h"
#include "voxc/Input/Units.h"

#include <algorithm>
#include <cmath>

namespace voxc {

namespace {

/// Of the line that begins with `name` and "="; empty if there is none.
std::string_view lineValue(std::string_view description, std::string_view name) {
  while (!description.empty()) {
    const std::string_view line = description.substr(0, description.find('\n'));
    description.remove_prefix(std::min(line.size() + 1, description.size()));
    if (line.starts_with(name) && line.substr(name.size()).starts_with('='))
      return trimmed(line.substr(name.size() + 1));
  }
  return {};
}

/// ImageJ writes the sign of a micrometre in several ways: as Java does, in UTF-8 of either code, or in
/// Latin-1.
double metresOfUnit(std::string_view unit) {
  for (const std::string_view micro : {"\\u00B5m", "\\u00b5m", "\xc2\xb5m", "\xce\xbcm", "\xb5m"})
    if (unit == micro)
      return 1e-6;
  return metresOf(unit).value_or(0);
}

bool isStep(double step) { return std::isnormal(step) && step > 1e-30 && step < 1e30; }

} // namespace

std::uint64_t imageJImages(std::string_view description) {
  const auto images =
      description.starts_with("ImageJ") ? parseInteger(lineValue(description, "images")) : std::nullopt;
  return static_cast<std::uint64_t>(std::max<std::int64_t>(images.value_or(0), 0));
}

std::optional<StackSpacing> imageJSpacing(std::string_view description,
                                          const std::array<double, 2> &pixelsAUnit) {
  if (!description.starts_with("ImageJ"))
    return std::nullopt;
  const std::string_view unit = lineValue(description, "unit");
  const auto depth = parseNumber(lineValue(description, "spacing"));
  const bool hasUnit = !unit.empty() && !unit.starts_with("pixel");
  if (!depth && !hasUnit)
    return std::nullopt;
  StackSpacing spacing;
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (const double step = 1 / pixelsAUnit[axis]; pixelsAUnit[axis] > 0 && isStep(step))
      spacing.steps[axis] = step;
  // A stack that was turned round has a negative one.
  if (depth && isStep(std::abs(*depth)))
    spacing.steps[2] = std::abs(*depth);
  spacing.metres = hasUnit ? metresOfUnit(unit) : 0;
  return spacing;
}

} // namespace voxc
