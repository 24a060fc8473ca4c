// What of a voxel's colour its own light does not give, and the material that says the rest.
#pragma once

#include "Source/Export/VoxelLooks.h"

#include <array>
#include <cstdint>
#include <string>

namespace voxc {

/// The light that a look adds to the colour, in linear light from 0 to 1.
std::array<double, 3> givenLight(const VoxelLook &look);

/// The colour in linear light to which `light` is to be added for a voxel of this word; 0 where the light is
/// brighter.
std::array<double, 3> lightBelow(std::uint32_t word, const std::array<double, 3> &light);

/// The same as a word, so that the sum is the voxel's word again where it can be. Alpha stays.
std::uint32_t wordBelow(std::uint32_t word, const std::array<double, 3> &light);

/// What a file says by then.
inline constexpr const char *kBrighterLight =
    "some voxels give off more light than their colour has; they come back as bright as that light";

/// Whether the light is brighter than the voxel in a channel.
bool isBrighter(const std::array<double, 3> &light, std::uint32_t word);

/// A material of glTF of which colours are said elsewhere: its opening brace is that of
/// "pbrMetallicRoughness".
std::string materialOf(const VoxelLook &look, bool isTranslucent);

/// The same of a texture of colours and others of the same places: numbers of textures, -1 for none.
struct LookTextures {
  int emission = -1;
  int metal = -1;       ///< In red how clear it is.
  bool isClear = false; ///< Some texel is clear.
  float strength = 1;   ///< Of all light.
};
std::string materialOf(const LookTextures &textures, bool isTranslucent);

/// The member "extensionsUsed" with a comma before it, of materials that were written; or nothing.
std::string extensionsOf(const std::string &materials);

} // namespace voxc
