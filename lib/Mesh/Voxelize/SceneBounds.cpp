// Checks of what a scene refers to, and the box of its triangles.
#include "Mesh/Voxelize/SceneBounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voxc {

namespace {

/// Triangles between two looks at memory and progress.
constexpr std::uint64_t kStep = 64;

bool isTexture(const TriangleScene &scene, const TextureUse &use) {
  return use.texture < static_cast<std::int64_t>(scene.textures.size());
}

bool isComplete(const Texture &texture) {
  return texture.width > 0 && texture.height > 0 && texture.texels &&
         texture.texels->size() >=
             static_cast<std::uint64_t>(texture.width) * static_cast<std::uint64_t>(texture.height);
}

/// Is the attribute absent, or there for every vertex?
bool isOnePerVertex(const AttributeView &attribute, const MeshPart &part) {
  return !attribute || attribute.count >= part.positions.count;
}

bool isFinite(const glm::dvec3 &point) {
  return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}

} // namespace

Expected<void> checkReferences(const TriangleScene &scene) {
  for (const MeshInstance &instance : scene.instances)
    if (instance.part >= scene.parts.size())
      return Error::input("the mesh has an instance of a part that does not exist");
  for (const MeshPart &part : scene.parts) {
    if (part.material >= scene.materials.size())
      return Error::input("the mesh has a triangle with a material that does not exist");
    if (!isOnePerVertex(part.colours, part) || !isOnePerVertex(part.uvs, part) ||
        !isOnePerVertex(part.emissionUvs, part) || !isOnePerVertex(part.metalUvs, part))
      return Error::input("the mesh has colours or texture coordinates for some vertices but not for all");
  }
  for (const Material &material : scene.materials)
    if (!isTexture(scene, material.texture) || !isTexture(scene, material.alphaMask) ||
        !isTexture(scene, material.emissionTexture) || !isTexture(scene, material.metalTexture))
      return Error::input("the mesh has a material with a texture that does not exist");
  if (!std::all_of(scene.textures.begin(), scene.textures.end(), isComplete))
    return Error::input("the mesh has a texture without all its texels");
  return {};
}

Expected<Bounds> boundsOf(const TriangleScene &scene, const TriangleNumbers &numbers, WorkingMemory *memory,
                          const Progress &progress) {
  if (numbers.size() == 0)
    return Error::input("the mesh has no triangle");
  if (numbers.size() > std::numeric_limits<std::uint32_t>::max())
    return Error::input("the mesh has 2^32 triangles or more");
  BoundsBuilder builder;
  TriangleCursor cursor(scene, numbers);
  for (std::uint64_t number = 0; number < numbers.size(); ++number) {
    cursor.moveTo(number);
    for (const std::uint32_t vertex : cursor.vertices())
      if (vertex >= cursor.part().positions.count)
        return Error::input("the mesh has a triangle with a vertex that does not exist");
    const std::array<glm::dvec3, 3> corners = cursor.corners();
    if (!std::ranges::all_of(corners, [](const glm::dvec3 &corner) { return isFinite(corner); }))
      return Error::input("the mesh has a vertex whose coordinates are not finite numbers");
    if (!cursor.isCollapsed(corners))
      std::ranges::for_each(corners, [&](const glm::dvec3 &corner) { builder.add(corner); });
    if (number % kStep == 0) {
      VOXC_TRY(progress.check());
      if (memory)
        memory->relieve();
    }
  }
  if (!builder.bounds())
    return Error::input("the mesh has no triangle with an area: two corners of each lie in one place");
  return *builder.bounds();
}

} // namespace voxc
