// The colour of a PLY row.
#pragma once

#include "Mesh/Ply/PlyReader.h"

#include <array>
#include <cstdint>
#include <optional>

namespace voxc {

/// Finds an element's properties red, green, blue and alpha, and packs those of a row.
class PlyColour {
public:
  explicit PlyColour(const PlyElement &element);

  /// True if the element has red, green and blue.
  explicit operator bool() const { return channels_[0] && channels_[1] && channels_[2]; }

  /// RGBA8 of a row; floats count from 0 to 1, 16-bit values to 65535. Opaque white without colour.
  std::uint32_t operator()(const PlyRow &row) const;

private:
  struct Channel {
    std::size_t property;
    double scale;
  };
  std::array<std::optional<Channel>, 4> channels_;
};

} // namespace voxc
