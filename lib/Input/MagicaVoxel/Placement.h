// Rotations, reflections and translations of MagicaVoxel's scene graph, in whole numbers.
#pragma once

#include "voxc/Support/Geometry.h"

#include <array>
#include <cstdint>
#include <optional>

namespace voxc {

using Long3 = std::array<std::int64_t, 3>;

/// Maps p to R p + t, where R permutes the axes and turns some of them around.
class Placement {
public:
  /// The rotation that a file writes as one byte: bits 0-1 say which axis the first row takes, bits 2-3 the
  /// second, bits 4-6 which rows are negative. Nothing if two rows take one axis.
  static std::optional<Placement> fromByte(unsigned byte);

  void setTranslation(const Long3 &translation) { translation_ = translation; }

  /// First `inner`, then this one. Nothing if the translation leaves what can be reached.
  std::optional<Placement> around(const Placement &inner) const;

  /// The low corner of the unit cell at `cell` after the map.
  Long3 moveCell(const Long3 &cell) const;

  /// The low corner of the box [low, low + size) after the map.
  Long3 moveBox(const Long3 &low, const Long3 &size) const;
  /// The size of a box after the map.
  Long3 turnSize(const Long3 &size) const;

private:
  std::array<std::uint8_t, 3> axis_{0, 1, 2}; ///< The axis that each row takes.
  std::array<std::int8_t, 3> sign_{1, 1, 1};
  Long3 translation_{};
};

} // namespace voxc
