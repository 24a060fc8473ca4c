// What tests of the readers share: small files, and scenes as plain triangles.
#pragma once

#include "Source/SourceTesting.h"

#include "voxc/Mesh/TriangleScene.h"

#include <algorithm>
#include <cstring>

namespace voxc {

using ReadCorner = std::array<double, 3>;

/// Whether one of them says that.
inline bool has(const std::vector<std::string> &warnings, const std::string &what) {
  return std::ranges::any_of(warnings,
                             [&](const std::string &w) { return w.find(what) != std::string::npos; });
}

/// Loads files of a folder that disappears.
class LoadTest : public testing::Test {
protected:
  TriangleScene load(const std::string &name, const std::string &content) {
    auto scene = loadScene(folder_.file(name, content), memory_);
    EXPECT_TRUE(scene) << scene.error().message;
    return scene ? std::move(*scene) : TriangleScene{};
  }
  std::string problem(const std::string &name, const std::string &content) {
    auto scene = loadScene(folder_.file(name, content), memory_);
    return scene ? "no error" : scene.error().message;
  }

  TemporaryFolder folder_;
  std::shared_ptr<WorkingMemory> memory_ = WorkingMemory::create(std::uint64_t{64} << 20);
};

inline ReadCorner transformed(const Transform &transform, const ReadCorner &point) {
  const glm::dvec3 moved = transform * glm::dvec4(point[0], point[1], point[2], 1);
  return {moved.x, moved.y, moved.z};
}

/// The corners of every triangle, in model space.
inline std::vector<std::array<ReadCorner, 3>> trianglesOf(const TriangleScene &scene) {
  std::vector<std::array<ReadCorner, 3>> triangles;
  for (const MeshInstance &instance : scene.instances) {
    const MeshPart &part = scene.parts[instance.part];
    for (std::uint64_t i = 0; i < part.triangles(); ++i) {
      std::array<ReadCorner, 3> &triangle = triangles.emplace_back();
      for (std::size_t corner = 0; corner < 3; ++corner)
        triangle[corner] = transformed(instance.toModel, readRow<3>(part.positions, part.corners(i)[corner]));
    }
  }
  return triangles;
}

inline std::uint64_t countTriangles(const TriangleScene &scene) {
  std::uint64_t count = 0;
  for (const MeshInstance &instance : scene.instances)
    count += scene.parts[instance.part].triangles();
  return count;
}

inline const Material &materialOf(const TriangleScene &scene, std::size_t part) {
  return scene.materials[scene.parts[part].material];
}

/// The bytes of values as they lie in memory.
template <typename Value> std::string bytesOf(std::initializer_list<Value> values) {
  return {reinterpret_cast<const char *>(values.begin()), values.size() * sizeof(Value)};
}

/// 2 x 1 texels as an uncompressed TGA from the top: red, then green at a quarter of its alpha.
inline const std::string kImage("\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\40\50\0\0\377\377\0\377\0\100", 26);
inline const std::vector<std::uint32_t> kTexels{0xff0000ff, 0x4000ff00};

inline std::vector<std::uint32_t> texelsOf(const Texture &texture) {
  const auto texels = texture.texels->span();
  return {texels.begin(), texels.end()};
}

} // namespace voxc
