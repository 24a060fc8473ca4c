// Emission is added to the colour: with a black one it is what is left.
#include "Input/Openers/MeshWords.h"

#include "voxc/Input/EmissionStrength.h"

#include <algorithm>
#include <array>

namespace voxc {

namespace {

void makeBlack(TriangleScene &scene) {
  for (Material &material : scene.materials)
    std::fill_n(material.colour.begin(), 3, 0.0f);
}

Expected<void> showEmission(TriangleScene &scene) {
  const auto gives = [](const Material &material) { return material.emission != Material().emission; };
  if (!std::ranges::any_of(scene.materials, gives))
    return Error::input("no material of the model gives off light");
  makeBlack(scene);
  return {};
}

/// The light that is given off in place of what is there: the float's bits, as bytes of a word.
Expected<void> showStrength(TriangleScene &scene) {
  VOXC_TRY(showEmission(scene));
  for (Material &material : scene.materials) {
    const bool gives = material.emission != Material().emission;
    const std::uint32_t word = gives ? strengthWord(material.emissionStrength) : 0;
    material.isLinear = false; // Numbers as they are.
    material.emissionTexture = {};
    for (std::size_t i = 0; i < material.emission.size(); ++i)
      material.emission[i] = static_cast<float>(word >> 8 * i & 255) / 255;
  }
  return {};
}

Expected<void> showMetal(TriangleScene &scene) {
  if (!std::ranges::any_of(scene.materials, &Material::hasMetal))
    return Error::input("no material of the model says how metallic or rough it is");
  makeBlack(scene);
  for (Material &material : scene.materials) {
    material.isLinear = false; // Numbers as they are.
    material.emission = {material.clear, material.roughness, material.metallic};
    material.emissionTexture = material.metalTexture;
  }
  for (MeshPart &part : scene.parts)
    part.emissionUvs = part.metalUvs;
  return {};
}

/// In the order of `MaterialWords`.
constexpr std::array<Expected<void> (*)(TriangleScene &), 4> kShows{
    [](TriangleScene &) { return Expected<void>(); }, showEmission, showStrength, showMetal};

} // namespace

Expected<void> showWords(TriangleScene &scene, MaterialWords words) {
  return kShows[static_cast<std::size_t>(words)](scene);
}

} // namespace voxc
