// Checks of every index and coordinate of a mesh.
#include "Mesh/MeshCheck.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voxc {

namespace {

bool isFinite(const Float3 &point) {
  return std::all_of(point.begin(), point.end(), [](float c) { return std::isfinite(c); });
}

bool isTexture(const TriangleMesh &mesh, int index) {
  return index < static_cast<std::int64_t>(mesh.textures.size());
}

bool isComplete(const Texture &texture) {
  return texture.width > 0 && texture.height > 0 &&
         texture.texels.size() ==
             static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height);
}

bool hasValidIndices(const TriangleMesh &mesh, const Triangle &triangle) {
  return triangle.material < mesh.materials.size() &&
         std::all_of(
             triangle.vertices.begin(), triangle.vertices.end(),
             [&](std::uint32_t vertex) { return vertex < mesh.positions.size(); });
}

bool isOnePerVertex(const TriangleMesh &mesh, std::size_t count) {
  return count == 0 || count == mesh.positions.size();
}

} // namespace

Expected<void> checkMesh(const TriangleMesh &mesh) {
  if (mesh.triangles.empty())
    return Error::input("the mesh has no triangle");
  if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max())
    return Error::input("the mesh has more than 2^32 triangles");
  if (!isOnePerVertex(mesh, mesh.colours.size()) || !isOnePerVertex(mesh, mesh.uvs.size()))
    return Error::input("the mesh has colours or texture coordinates for some vertices but not for all");
  for (const Triangle &triangle : mesh.triangles)
    if (!hasValidIndices(mesh, triangle))
      return Error::input("the mesh has a triangle with a vertex or material that does not exist");
  for (const Material &material : mesh.materials)
    if (!isTexture(mesh, material.texture) || !isTexture(mesh, material.alphaMask))
      return Error::input("the mesh has a material with a texture that does not exist");
  if (!std::all_of(mesh.textures.begin(), mesh.textures.end(), isComplete))
    return Error::input("the mesh has a texture without all its texels");
  if (!std::all_of(mesh.positions.begin(), mesh.positions.end(), isFinite))
    return Error::input("the mesh has a vertex whose coordinates are not finite numbers");
  return {};
}

} // namespace voxc
