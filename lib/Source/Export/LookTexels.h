// Texels that say what looks say, for textures beside that of colours.
#pragma once

#include "Source/Export/LookPaint.h"
#include "Source/Export/VoxelLooks.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace voxc {

class LookTexels {
public:
  enum class Kind { Emission, Metal };

  /// The looks must outlive this; the first is that of voxels of which nothing is said.
  explicit LookTexels(std::span<const VoxelLook> looks);

  bool areAny() const { return !kinds_.empty(); }
  /// The textures that are needed, in their order behind that of colours.
  std::span<const Kind> kinds() const { return kinds_; }
  std::uint32_t texel(Kind kind, std::uint32_t look) const;
  /// What a look's texel adds to the colour.
  const std::array<double, 3> &light(std::uint32_t look) const { return lights_[look]; }
  LookTextures textures() const { return textures_; }
  /// A sentence about strengths that differ; or empty.
  std::string warning() const;

private:
  std::span<const VoxelLook> looks_;
  std::vector<std::uint32_t> emissions_; ///< Texels.
  std::vector<std::array<double, 3>> lights_;
  std::vector<Kind> kinds_;
  LookTextures textures_;
  bool isOneStrength_ = true;
};

} // namespace voxc
