// Finding and packing the colours of PLY rows.
#include "Mesh/Ply/PlyColour.h"

#include "Mesh/Ply/PlyBits.h"

#include <bit>
#include <cmath>
#include <string_view>

namespace voxc {

namespace {

using Names = std::array<std::string_view, 4>;

/// As MeshLab, Blender, CloudCompare, PCL and others write them.
constexpr std::array<Names, 9> kNames{{{"red", "green", "blue", "alpha"},
                                       {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"},
                                       {"r", "g", "b", "a"},
                                       {"diffuse_r", "diffuse_g", "diffuse_b", "diffuse_a"},
                                       {"color_red", "color_green", "color_blue", "color_alpha"},
                                       {"colour_red", "colour_green", "colour_blue", "colour_alpha"},
                                       {"color_r", "color_g", "color_b", "color_a"},
                                       {"colour_r", "colour_g", "colour_b", "colour_a"},
                                       {"scalar_red", "scalar_green", "scalar_blue", "scalar_alpha"}}};

} // namespace

PlyColour::PlyColour(const PlyElement &element) : element_(element) {
  for (const Names &names : kNames) {
    for (std::size_t i = 0; i < channels_.size(); ++i)
      channels_[i] = findNumber(element, names[i]);
    if (!channels_[3])
      channels_[3] = findNumber(element, "alpha");
    if (*this)
      return;
  }
  channels_ = {};
  for (const std::string_view name : {"rgba", "rgb"})
    if (const auto found = findNumber(element, name);
        found && !isPacked_ && byteSize(element.properties[*found].type) == 4) {
      channels_[0] = found;
      isPacked_ = true;
    }
}

bool PlyColour::isByte(std::size_t channel) const {
  return !channels_[channel] || byteSize(element_.properties[*channels_[channel]].type) == 1;
}

bool PlyColour::areBytes() const {
  if (!*this || isPacked_)
    return false;
  for (const auto &channel : channels_)
    if (channel && element_.properties[*channel].type != PlyType::Uint8)
      return false;
  return true;
}

/// A signed byte stands for an unsigned one.
double PlyColour::value(std::size_t channel, const PlyRow &row) const {
  const double value = row.values[*channels_[channel]];
  return value < 0 && element_.properties[*channels_[channel]].type == PlyType::Int8 ? value + 256 : value;
}

void PlyColour::look(const PlyRow &row) {
  for (std::size_t i = 0; i < channels_.size(); ++i)
    if (channels_[i])
      scales_[i / 3].add(value(i, row));
}

double PlyColour::wholeOf(std::size_t channel) const {
  const PlyType type = element_.properties[*channels_[channel]].type;
  if (byteSize(type) == 1)
    return 255;
  return isInteger(type) ? scales_[channel / 3].wholeOfIntegers() : scales_[channel / 3].whole();
}

/// Blue in the low byte, as PCL has it; a float stands for its bits.
std::uint32_t PlyColour::unpacked(double value) const {
  const PlyProperty &property = element_.properties[*channels_[0]];
  const std::uint32_t word = isInteger(property.type)
                                 ? static_cast<std::uint32_t>(static_cast<std::int64_t>(value))
                                 : narrowedBits(value);
  const std::uint32_t alpha = property.name.size() == 4 ? word & 0xff000000 : 0xff000000;
  return alpha | (word & 255) << 16 | (word & 0xff00) | (word >> 16 & 255);
}

std::uint32_t PlyColour::operator()(const PlyRow &row) const {
  if (!*this)
    return 0xffffffff;
  if (isPacked_)
    return unpacked(row.values[*channels_[0]]);
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    const double level = channels_[i] ? value(i, row) * (255 / wholeOf(i)) : 255;
    // Written so that NaN becomes 0.
    const double bounded = level > 0 ? std::fmin(level, 255) : 0;
    word |= static_cast<std::uint32_t>(std::lround(bounded)) << 8 * i;
  }
  return word;
}

void PlyColour::take(PlyUse &use) const {
  if (*this)
    for (const auto &channel : channels_)
      use.take(element_, channel);
}

std::string PlyColour::warning() const {
  if (!needsLook() || isByte(0))
    return {};
  const PlyType type = element_.properties[*channels_[0]].type;
  const double expected = !isInteger(type) ? 1 : byteSize(type) == 2 ? 65535 : 255;
  const double whole = wholeOf(0);
  if (whole == 1 && scales_[0].largest() > 1)
    return "some colours are above 1, and are cut there";
  return whole == expected
             ? std::string()
             : "the colours of the element '" + element_.name + "' are taken as numbers that count to " +
                   std::to_string(static_cast<std::uint64_t>(whole));
}

Expected<void> lookAtColours(const PlyReader &reader, const PlyElement &element, PlyColour &colour,
                             const std::function<Expected<void>(std::uint64_t row)> &stopped) {
  if (!colour.needsLook())
    return {};
  auto again = VOXC_TRY(reader.reopened());
  const auto place = static_cast<std::size_t>(&element - reader.header().elements.data());
  const PlyElement &same = again.header().elements[place];
  return again.readRows(
      [&](const PlyElement &other, std::uint64_t index, const PlyRow &row) -> Expected<void> {
        if (&other == &same)
          colour.look(row);
        return stopped(index);
      });
}

} // namespace voxc
