// Facts of meshes.
#include "Input/Openers/MeshFacts.h"

#include "Input/Openers/InputText.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

namespace voxc {

namespace {

/// The box of all vertices of all instances, in the units of the model.
InputFact boxOf(const TriangleScene &scene) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  glm::dvec3 low(kFar), high(-kFar);
  for (const MeshInstance &instance : scene.instances) {
    const AttributeView &positions = scene.parts[instance.part].positions;
    for (std::uint64_t row = 0; row < positions.count; ++row) {
      const std::array<double, 3> position = readRow<3>(positions, row);
      const glm::dvec3 placed = instance.toModel * glm::dvec4(position[0], position[1], position[2], 1);
      low = glm::min(low, placed);
      high = glm::max(high, placed);
    }
  }
  return boxFact("box", {low.x, low.y, low.z}, {high.x, high.y, high.z});
}

/// Where the colours come from.
InputFact coloursOf(const TriangleScene &scene) {
  const auto hasColours = [](const MeshPart &part) { return bool(part.colours); };
  const auto isColoured = [](const Material &material) { return material.colour != Material().colour; };
  const auto isGlowing = [](const Material &material) { return material.emission != Material().emission; };
  std::string text;
  const auto add = [&](std::ptrdiff_t count, const char *one, const char *many) {
    if (count > 0)
      text += (text.empty() ? "" : ", ") + std::to_string(count) + (count == 1 ? one : many);
  };
  add(std::ssize(scene.textures), " texture", " textures");
  add(std::ranges::count_if(scene.materials, isColoured), " coloured material", " coloured materials");
  add(std::ranges::count_if(scene.materials, isGlowing), " material that gives off light",
      " materials that give off light");
  add(std::ranges::count_if(scene.parts, hasColours), " part with vertex colours",
      " parts with vertex colours");
  return {"colours", text.empty() ? "none; it is white" : std::move(text), {}};
}

} // namespace

std::vector<InputFact> factsOf(const TriangleScene &scene) {
  return {countFact("triangles", triangleCount(scene)),
          countFact("parts", scene.parts.size()),
          countFact("instances", scene.instances.size()),
          countFact("materials", scene.materials.size()),
          coloursOf(scene),
          boxOf(scene)};
}

} // namespace voxc
