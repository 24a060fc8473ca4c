// Emission is added to the colour: with a black one it is what is left.
#include "Input/Openers/MeshWords.h"

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

Expected<void> showMetal(TriangleScene &scene) {
  if (!std::ranges::any_of(scene.materials, &Material::hasMetal))
    return Error::input("no material of the model says how metallic or rough it is");
  makeBlack(scene);
  for (Material &material : scene.materials) {
    material.isLinear = false; // Numbers as they are.
    material.emission = {0, material.roughness, material.metallic};
    material.emissionTexture = material.metalTexture;
  }
  for (MeshPart &part : scene.parts)
    part.emissionUvs = part.metalUvs;
  return {};
}

/// In the order of `MaterialWords`.
constexpr std::array<Expected<void> (*)(TriangleScene &), 3> kShows{
    [](TriangleScene &) { return Expected<void>(); }, showEmission, showMetal};

} // namespace

Expected<void> showWords(TriangleScene &scene, MaterialWords words) {
  return kShows[static_cast<std::size_t>(words)](scene);
}

} // namespace voxc
