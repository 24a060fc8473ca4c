// A texture of what is given off, and one of metal.
#include "Source/Export/LookTexels.h"

#include "Source/Export/GlbFile.h"
#include "Support/Srgb.h"

#include <algorithm>

namespace voxc {

LookTexels::LookTexels(std::span<const VoxelLook> looks) : looks_(looks) {
  bool hasEmission = false, hasMetal = false;
  for (const VoxelLook &look : looks) {
    const std::array<double, 3> given = givenLight(look);
    std::uint32_t texel = 0xff000000;
    std::array<double, 3> light{};
    for (std::size_t i = 0; i < light.size(); ++i) {
      const std::uint32_t byte = srgbByte(given[i]);
      texel |= byte << 8 * i;
      light[i] = kLinearLight[byte];
    }
    emissions_.push_back(texel);
    lights_.push_back(light);
    const float strength = std::max(look.strength, 1.0F);
    isOneStrength_ = isOneStrength_ && (look.emission == 0 || !hasEmission || strength == textures_.strength);
    if (look.emission != 0)
      textures_.strength = std::max(strength, textures_.strength);
    hasEmission = hasEmission || look.emission != 0;
    hasMetal = hasMetal || look.metal != 0;
    textures_.isClear = textures_.isClear || (look.metal & 255) != 0;
  }
  int texture = 1;
  if (hasEmission) {
    textures_.emission = texture++;
    kinds_.push_back(Kind::Emission);
  }
  if (hasMetal) {
    textures_.metal = texture++;
    kinds_.push_back(Kind::Metal);
  }
}

std::uint32_t LookTexels::texel(Kind kind, std::uint32_t look) const {
  constexpr std::uint32_t kRough = 0xff00ff00;
  if (kind == Kind::Emission)
    return emissions_[look];
  return looks_[look].metal == 0 ? kRough : looks_[look].metal;
}

std::string LookTexels::warning() const {
  return isOneStrength_ ? std::string()
                        : "its voxels give off light of several strengths, of which a texture holds one: " +
                              jsonNumber(textures_.strength) + " stands for all";
}

} // namespace voxc
