// The two conventions, and telling them apart.
#include "Mesh/Stl/StlColours.h"

#include <string_view>

namespace voxc {

namespace {

constexpr std::string_view kObjectMark = "COLOR=";
constexpr std::string_view kMaterialMark = "MATERIAL=";

/// Five bits as eight.
std::uint32_t channel(unsigned bits) { return ((bits & 31) * 255 + 15) / 31; }

} // namespace

StlColours::StlColours(std::span<const std::byte> header) {
  const std::string_view text(reinterpret_cast<const char *>(header.data()), header.size());
  const std::size_t mark = text.find(kObjectMark);
  if (mark == std::string_view::npos || mark + kObjectMark.size() + 4 > text.size())
    return;
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i)
    word |= std::uint32_t{static_cast<unsigned char>(text[mark + kObjectMark.size() + i])} << 8 * i;
  // What would be wholly invisible is meant to be opaque.
  object_ = word >> 24 == 0 ? word | 0xff000000 : word;
  hasMaterial_ = text.find(kMaterialMark, mark) != std::string_view::npos;
}

std::uint32_t StlColours::operator()(std::uint16_t bytes) const {
  // Bytes that are 0 everywhere are not black, but were never written.
  if (object_)
    return (bytes & kFlag) != 0 || all_ == 0
               ? *object_
               : channel(bytes) | channel(bytes >> 5) << 8 | channel(bytes >> 10) << 16 | 0xff000000;
  if ((bytes & kFlag) == 0)
    return 0xffffffff;
  return channel(bytes >> 10) | channel(bytes >> 5) << 8 | channel(bytes) << 16 | 0xff000000;
}

std::string StlColours::warning() const {
  if (!areThere() && all_ != 0)
    return "the two bytes behind each triangle are not 0, and are no colours; they are not used";
  return hasMaterial_ ? "the header has a MATERIAL, which is not used" : std::string();
}

} // namespace voxc
