// What every fuzzer of a mesh reader does with a scene: all that the voxelizer may do.
#pragma once

#include "voxc/Mesh/TriangleScene.h"

#include <algorithm>
#include <cstdlib>

namespace voxc::fuzz {

inline constexpr std::uint64_t kBound = std::uint64_t{256} << 20;
inline constexpr std::uint64_t kMostTriangles = 20000; ///< Of a part, at either end.

inline void require(bool condition) {
  if (!condition)
    std::abort();
}

inline double touch(const AttributeView &view, std::uint64_t row) {
  if (!view)
    return 0;
  const auto [x, y, z, w] = readRow<4>(view, row);
  return x + y + z + w;
}

inline double touchTriangle(const MeshPart &part, std::uint64_t triangle) {
  double sum = 0;
  for (const std::uint32_t corner : part.corners(triangle)) {
    require(corner < part.positions.count);
    sum += touch(part.positions, corner) + touch(part.uvs, corner) + touch(part.colours, corner) +
           touch(part.emissionUvs, corner) + touch(part.metalUvs, corner);
  }
  return sum;
}

inline double touchPart(const MeshPart &part) {
  const std::uint64_t count = part.triangles();
  double sum = 0;
  for (std::uint64_t i = 0; i < std::min(count, kMostTriangles); ++i)
    sum += touchTriangle(part, i) + touchTriangle(part, count - 1 - i);
  return sum;
}

inline void requireTexture(const TriangleScene &scene, const TextureUse &use) {
  require(use.texture >= -1 && use.texture < static_cast<int>(scene.textures.size()));
}

/// Reads the scene through and aborts if it breaks what its type promises.
inline void useScene(const TriangleScene &scene) {
  volatile double sum = 0;
  for (const MeshInstance &instance : scene.instances)
    require(instance.part < scene.parts.size());
  for (const MeshPart &part : scene.parts) {
    require(part.material < scene.materials.size());
    sum = sum + touchPart(part);
  }
  require(!scene.materials.empty());
  for (const Material &material : scene.materials) {
    requireTexture(scene, material.texture);
    requireTexture(scene, material.alphaMask);
    requireTexture(scene, material.emissionTexture);
    requireTexture(scene, material.metalTexture);
  }
  for (const Texture &texture : scene.textures)
    require(texture.width > 0 && texture.height > 0 &&
            texture.texels->size() == std::uint64_t(texture.width) * std::uint64_t(texture.height));
}

/// Loads a file and uses what comes out of it.
inline void loadAndUse(const std::string &path) {
  if (auto scene = loadScene(path, WorkingMemory::create(kBound)))
    useScene(*scene);
}

} // namespace voxc::fuzz
