// Levels and formats: sizes and attributes.
#include "voxc/IR/Format.h"

#include <algorithm>

namespace voxc {

std::uint32_t Level::parameter(ParameterRole role) const {
  for (std::size_t i = 0; i < kind->parameters.size(); ++i)
    if (kind->parameters[i].role == role)
      return parameters[i];
  return 0;
}

Int3 Level::log2Size() const {
  const auto size = [&](ParameterRole role) { return static_cast<std::int32_t>(parameter(role)); };
  if (kind->arrangement == Arrangement::Tree)
    return {size(ParameterRole::Side), size(ParameterRole::Side), size(ParameterRole::Side)};
  return {size(ParameterRole::Width), size(ParameterRole::Height), size(ParameterRole::Depth)};
}

bool Level::isCubic() const {
  const Int3 size = log2Size();
  return size.x == size.y && size.y == size.z;
}

std::string_view Level::attribute(const AttributeKind &attribute) const {
  for (const Attribute &set : attributes)
    if (set.kind == &attribute)
      return attribute.values[set.value];
  return attribute.values[0];
}

bool Level::setAttribute(const AttributeKind &attribute, std::string_view value) {
  const auto takes = std::ranges::find(kind->attributes, &attribute) != kind->attributes.end();
  if (!takes || this->attribute(attribute) == value)
    return false;
  std::erase_if(attributes, [&](const Attribute &set) { return set.kind == &attribute; });
  const auto index =
      static_cast<std::size_t>(std::ranges::find(attribute.values, value) - attribute.values.begin());
  if (index > 0)
    attributes.push_back({&attribute, index});
  // Kept in the kind's order, so that equal formats compare equal whatever the order of the passes.
  std::ranges::sort(attributes, {}, [&](const Attribute &set) {
    return std::ranges::find(kind->attributes, set.kind) - kind->attributes.begin();
  });
  return true;
}

Int3 Format::log2Extent() const {
  Int3 extent;
  for (const Level &level : levels)
    extent = extent + level.log2Size();
  return extent;
}

Int3 Format::extent() const {
  const Int3 log2 = log2Extent();
  return {1 << log2.x, 1 << log2.y, 1 << log2.z};
}

int Format::log2CellSide(std::size_t index) const {
  int side = 0;
  for (std::size_t i = index + 1; i < levels.size(); ++i)
    side += levels[i].log2Size().x;
  return side;
}

Format storageFormat(Format format) {
  for (Level &level : format.levels)
    std::erase_if(level.attributes,
                  [](const Attribute &set) { return set.kind->effect == AttributeEffect::Walk; });
  return format;
}

} // namespace voxc
