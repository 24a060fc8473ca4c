// Finding and packing the colours of PLY rows.
#include "Mesh/Ply/PlyColour.h"

#include <cmath>
#include <string_view>

namespace voxc {

namespace {

constexpr std::array<std::string_view, 4> kNames{"red", "green", "blue", "alpha"};
constexpr std::array<std::string_view, 4> kDiffuseNames{"diffuse_red", "diffuse_green", "diffuse_blue",
                                                        "diffuse_alpha"};

double channelScale(PlyType type) {
  if (!isInteger(type))
    return 255;
  return byteSize(type) == 2 ? 255.0 / 65535 : 1;
}

} // namespace

PlyColour::PlyColour(const PlyElement &element) {
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    auto found = element.find(kNames[i]);
    if (!found)
      found = element.find(kDiffuseNames[i]);
    if (found)
      channels_[i] = Channel{*found, channelScale(element.properties[*found].type)};
  }
}

std::uint32_t PlyColour::operator()(const PlyRow &row) const {
  if (!*this)
    return 0xffffffff;
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    const double value = channels_[i] ? row.values[channels_[i]->property] * channels_[i]->scale : 255;
    // Written so that NaN becomes 0.
    const double bounded = value > 0 ? std::fmin(value, 255) : 0;
    word |= static_cast<std::uint32_t>(std::lround(bounded)) << 8 * i;
  }
  return word;
}

} // namespace voxc
