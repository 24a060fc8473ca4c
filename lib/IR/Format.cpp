// Levels and formats: sizes and attributes.
#include "voxc/IR/Format.h"

namespace voxc {

std::uint32_t Level::parameter(ParameterRole role) const {
  for (std::size_t i = 0; i < kind->parameters.size(); ++i)
    if (kind->parameters[i].role == role)
      return parameters[i];
  return 0;
}

Int3 Level::log2Size() const {
  const auto size = [&](ParameterRole role) { return static_cast<std::int32_t>(parameter(role)); };
  if (kind->isTree())
    return {size(ParameterRole::Side), size(ParameterRole::Side), size(ParameterRole::Side)};
  return {size(ParameterRole::Width), size(ParameterRole::Height), size(ParameterRole::Depth)};
}

bool Level::isCubic() const {
  const Int3 size = log2Size();
  return size.x == size.y && size.y == size.z;
}

bool Level::setAttribute(const AttributeKind &attribute, std::string_view value) {
  return attributes.set(kind->attributes, attribute, value);
}

bool Format::setAttribute(const AttributeKind &attribute, std::string_view value) {
  return attributes.set(formatAttributes(), attribute, value);
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
  format.attributes.eraseTraversal();
  for (Level &level : format.levels)
    level.attributes.eraseTraversal();
  return format;
}

Format canonicalFormat(Format format) {
  format = storageFormat(std::move(format));
  // The first level has one sub-volume, and nothing to share it with.
  Level &first = format.levels.front();
  for (const AttributeKind *kind : first.kind->attributes)
    if (kind->amongSubVolumes)
      first.setAttribute(*kind, kind->values.front());
  return format;
}

} // namespace voxc
