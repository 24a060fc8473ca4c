// Placing boxes and cells.
#include "Input/MagicaVoxel/Placement.h"

#include <cstdlib>

namespace voxc {

std::optional<Placement> Placement::fromByte(unsigned byte) {
  const unsigned first = byte & 3;
  const unsigned second = byte >> 2 & 3;
  if (byte > 0x7f || first == 3 || second == 3 || first == second)
    return std::nullopt;
  Placement placement;
  placement.axis_ = {static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(second),
                     static_cast<std::uint8_t>(3 - first - second)};
  for (unsigned row = 0; row < 3; ++row)
    placement.sign_[row] = byte >> (4 + row) & 1 ? -1 : 1;
  return placement;
}

std::optional<Placement> Placement::around(const Placement &inner) const {
  // Translations are 32-bit in what MagicaVoxel writes, and a scene takes 2^21 cells an axis.
  constexpr std::int64_t kFarthest = std::int64_t{1} << 40;
  Placement result;
  for (std::size_t row = 0; row < 3; ++row) {
    const std::size_t from = axis_[row];
    result.axis_[row] = inner.axis_[from];
    result.sign_[row] = static_cast<std::int8_t>(sign_[row] * inner.sign_[from]);
    result.translation_[row] = translation_[row] + sign_[row] * inner.translation_[from];
    if (std::abs(result.translation_[row]) > kFarthest)
      return std::nullopt;
  }
  return result;
}

Long3 Placement::moveCell(const Long3 &cell) const { return moveBox(cell, {1, 1, 1}); }

Long3 Placement::moveBox(const Long3 &low, const Long3 &size) const {
  Long3 moved;
  for (std::size_t row = 0; row < 3; ++row) {
    const std::size_t from = axis_[row];
    const std::int64_t corner = sign_[row] > 0 ? low[from] : -(low[from] + size[from]);
    moved[row] = corner + translation_[row];
  }
  return moved;
}

Long3 Placement::turnSize(const Long3 &size) const {
  return {size[axis_[0]], size[axis_[1]], size[axis_[2]]};
}

} // namespace voxc
