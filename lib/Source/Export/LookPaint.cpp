// Materials of glTF: the colour of a surface is that of the material and the light that it gives off.
#include "Source/Export/LookPaint.h"

#include "Source/Export/GlbFile.h"
#include "Support/Srgb.h"

#include <algorithm>
#include <string_view>

namespace voxc {

namespace {

constexpr std::string_view kStrengthExtension = "KHR_materials_emissive_strength";
constexpr std::string_view kTransmissionExtension = "KHR_materials_transmission";

std::uint32_t byteOf(std::uint32_t word, std::size_t channel) { return word >> 8 * channel & 255; }

std::string member(std::string_view extension, const std::string &content) {
  return "\"" + std::string(extension) + "\":{" + content + "}";
}

std::string strengthText(float strength) {
  return strength > 1 ? member(kStrengthExtension, "\"emissiveStrength\":" + jsonNumber(strength)) : "";
}

/// What stands behind the metal and roughness of a material.
std::string rest(const std::string &emission, const std::string &strength, const std::string &transmission,
                 bool isTranslucent) {
  std::string text = emission + (isTranslucent ? R"(,"alphaMode":"BLEND")" : "");
  if (!strength.empty() || !transmission.empty())
    text += ",\"extensions\":{" + strength + (strength.empty() || transmission.empty() ? "" : ",") +
            transmission + "}";
  return text;
}

} // namespace

std::array<double, 3> givenLight(const VoxelLook &look) {
  std::array<double, 3> light{};
  for (std::size_t i = 0; i < light.size(); ++i)
    light[i] = kLinearLight[byteOf(look.emission, i)] * std::min(look.strength, 1.0F);
  return light;
}

std::array<double, 3> lightBelow(std::uint32_t word, const std::array<double, 3> &light) {
  std::array<double, 3> below{};
  for (std::size_t i = 0; i < below.size(); ++i)
    below[i] = std::max(kLinearLight[byteOf(word, i)] - light[i], 0.0);
  return below;
}

std::uint32_t wordBelow(std::uint32_t word, const std::array<double, 3> &light) {
  const std::array<double, 3> below = lightBelow(word, light);
  std::uint32_t result = word & 0xff000000;
  for (std::size_t i = 0; i < below.size(); ++i) {
    const std::uint32_t nearest = srgbByte(below[i]);
    std::uint32_t best = nearest;
    // Rounded twice, the sum may be a step beside.
    for (const std::uint32_t tried : {nearest + 1, nearest - 1, nearest})
      if (tried <= 255 && srgbByte(kLinearLight[tried] + light[i]) == byteOf(word, i))
        best = tried;
    result |= best << 8 * i;
  }
  return result;
}

bool isBrighter(const std::array<double, 3> &light, std::uint32_t word) {
  for (std::size_t i = 0; i < light.size(); ++i)
    if (srgbByte(light[i]) > byteOf(word, i))
      return true;
  return false;
}

std::string materialOf(const VoxelLook &look, bool isTranslucent) {
  const auto share = [&](std::size_t channel) { return jsonNumber(byteOf(look.metal, channel) / 255.0); };
  const bool isSaid = look.metal != 0;
  std::string emission;
  if (look.emission != 0) {
    const std::array<double, 3> light = givenLight(look);
    emission = ",\"emissiveFactor\":[" + jsonNumber(light[0]) + "," + jsonNumber(light[1]) + "," +
               jsonNumber(light[2]) + "]";
  }
  const bool isClear = byteOf(look.metal, 0) != 0;
  return R"({"pbrMetallicRoughness":{"metallicFactor":)" + (isSaid ? share(2) : "0") +
         R"(,"roughnessFactor":)" + (isSaid ? share(1) : "1") + "}" +
         rest(emission, strengthText(look.strength),
              isClear ? member(kTransmissionExtension, "\"transmissionFactor\":" + share(0)) : "",
              isTranslucent) +
         "}";
}

std::string materialOf(const LookTextures &textures, bool isTranslucent) {
  const auto texture = [](std::string_view name, int index) {
    return "\"" + std::string(name) + "\":{\"index\":" + std::to_string(index) + "}";
  };
  const bool hasMetal = textures.metal >= 0;
  const std::string emission =
      textures.emission < 0 ? ""
                            : ",\"emissiveFactor\":[1,1,1]," + texture("emissiveTexture", textures.emission);
  const std::string transmission =
      textures.isClear ? member(kTransmissionExtension,
                                "\"transmissionFactor\":1," + texture("transmissionTexture", textures.metal))
                       : "";
  return "{\"pbrMetallicRoughness\":{" + texture("baseColorTexture", 0) +
         (hasMetal ? ",\"metallicFactor\":1,\"roughnessFactor\":1," +
                         texture("metallicRoughnessTexture", textures.metal)
                   : ",\"metallicFactor\":0,\"roughnessFactor\":1") +
         "}" + rest(emission, strengthText(textures.strength), transmission, isTranslucent) + "}";
}

std::string extensionsOf(const std::string &materials) {
  std::string names;
  for (const std::string_view name : {kStrengthExtension, kTransmissionExtension})
    if (materials.find(name) != std::string::npos)
      names += (names.empty() ? "\"" : ",\"") + std::string(name) + "\"";
  return names.empty() ? "" : ",\"extensionsUsed\":[" + names + "]";
}

} // namespace voxc
