// Triangles that share a voxel: by their areas in it, and only those of the surface that it shows.
#include "Mesh/Voxelize/VoxelMean.h"
#include "Mesh/Voxelize/MeshVoxels.h"

#include "SceneTesting.h"
#include "Source/SourceTesting.h"

#include <cmath>
#include <random>

namespace voxc {
namespace {

using test::HandPart;
using test::sceneOf;
using test::textureOf;
using Triangle = std::array<glm::dvec3, 3>;

constexpr std::uint32_t kBlack = rgba(0, 0, 0);
constexpr std::uint32_t kWhite = rgba(255, 255, 255);
constexpr std::uint32_t kRed = rgba(255, 0, 0);

TEST(VoxelMean, AreasOfWhatIsInTheVoxel) {
  const glm::dvec3 low(2, 3, 4);
  const auto area = [&](Triangle triangle) {
    for (glm::dvec3 &corner : triangle)
      corner += low;
    return areaInVoxel(triangle, low);
  };
  EXPECT_DOUBLE_EQ(area({{{0.25, 0.25, 0.5}, {0.75, 0.25, 0.5}, {0.25, 0.75, 0.5}}}), 0.125);
  EXPECT_DOUBLE_EQ(area({{{-9, -9, 0.5}, {30, -9, 0.5}, {-9, 30, 0.5}}}), 1);
  EXPECT_DOUBLE_EQ(area({{{0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}}}), 0.5);
  // The plane x + y + z = 3/2 cuts a regular hexagon out of the cube.
  EXPECT_NEAR(area({{{31.5, -15, -15}, {-15, 31.5, -15}, {-15, -15, 31.5}}}), 0.75 * std::sqrt(3), 1e-12);
  // What only touches has none, and neither has what is elsewhere.
  EXPECT_EQ(area({{{1, 0, 0.5}, {2, 0, 0.5}, {2, 1, 0.5}}}), 0);
  EXPECT_EQ(area({{{5, 5, 5}, {6, 5, 5}, {5, 6, 5}}}), 0);
}

TEST(VoxelMean, AreasOfAllVoxelsAreTheTriangles) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 6);
  for (int round = 0; round < 200; ++round) {
    Triangle triangle;
    for (glm::dvec3 &corner : triangle)
      corner = {place(random), place(random), place(random)};
    double sum = 0;
    for (int i = 0; i < 216; ++i)
      sum += areaInVoxel(triangle, {i % 6, i / 6 % 6, i / 36});
    EXPECT_NEAR(sum, glm::length(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0])) / 2, 1e-9);
  }
}

/// The voxels of a scene of 8 voxels a side, in chunks of either size.
Voxels voxelized(const std::shared_ptr<TriangleScene> &scene) {
  VoxelizeOptions options;
  options.resolution = 8;
  options.bounds = {{0, 0, 0, 8, 8, 8}};
  const auto memory = WorkingMemory::create(std::uint64_t{16} << 20);
  auto reference = makeReferenceMeshSource(*scene, options);
  EXPECT_TRUE(reference);
  const Voxels voxels = voxelsOf(**reference);
  for (const int log2Chunk : {3, 6}) {
    auto source = makeMeshSource(scene, options, memory, {log2Chunk});
    EXPECT_TRUE(source);
    EXPECT_EQ(voxelsOf(**source), voxels);
  }
  return voxels;
}

/// A square in the plane z of n x n squares of two triangles, over all of a texture.
HandPart grid(int n, float z, bool isTurned = false) {
  HandPart part;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) {
      const std::array<float, 2> uv{float(x) / float(n), float(y) / float(n)};
      part.positions.push_back({8 * uv[0], 8 * uv[1], z});
      part.uvs.push_back(uv);
    }
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const auto corner = static_cast<std::uint32_t>(y * (n + 1) + x);
      const auto above = corner + static_cast<std::uint32_t>(n) + 1;
      for (const std::uint32_t index : {corner, corner + 1, above + 1, corner, above + 1, above})
        part.indices.push_back(index);
    }
  if (isTurned)
    for (std::size_t i = 0; i < part.indices.size(); i += 3)
      std::swap(part.indices[i], part.indices[i + 1]);
  return part;
}

Texture filled(int size, std::uint32_t word) {
  return textureOf(size, size, std::vector<std::uint32_t>(static_cast<std::size_t>(size * size), word));
}

Material textured(int texture) {
  Material material;
  material.texture.texture = texture;
  return material;
}

TEST(VoxelMean, SmallTrianglesCountByTheirAreas) {
  std::vector<std::uint32_t> texels;
  for (int i = 0; i < 256 * 256; ++i)
    texels.push_back(i / 256 % 16 == 0 ? kBlack : kWhite);
  const Texture texture = textureOf(256, 256, texels);
  for (const int n : {1, 3, 32, 100}) {
    auto scene = sceneOf({grid(n, 0.5f)}, {textured(0)});
    scene->textures.push_back(texture);
    // A sixteenth of the light is missing, wherever the triangles end.
    for (const auto &[code, word] : voxelized(scene))
      EXPECT_NEAR(word & 255, 248, 2) << n;
  }
}

TEST(VoxelMean, OtherMaterialsDoNotCount) {
  HandPart far = grid(32, 0.9f);
  far.material = 1;
  for (const bool isFirst : {false, true}) {
    auto scene = isFirst ? sceneOf({far, grid(32, 0.4f)}, {textured(0), textured(1)})
                         : sceneOf({grid(32, 0.4f), far}, {textured(0), textured(1)});
    scene->textures.push_back(filled(64, kRed));
    scene->textures.push_back(filled(64, kWhite));
    for (const auto &[code, word] : voxelized(scene))
      EXPECT_EQ(word, kRed);
  }
}

TEST(VoxelMean, TheOtherSideOfAWallDoesNotCount) {
  // Both have one atlas, red in its left half and black in its right.
  std::vector<std::uint32_t> texels;
  for (int i = 0; i < 256 * 256; ++i)
    texels.push_back(i % 256 < 128 ? kRed : kBlack);
  HandPart front = grid(32, 0.4f);
  HandPart back = grid(32, 0.9f, true);
  for (std::size_t i = 0; i < front.uvs.size(); ++i) {
    front.uvs[i][0] = front.uvs[i][0] / 2;
    back.uvs[i][0] = 0.5f + back.uvs[i][0] / 2;
  }
  for (const bool isFirst : {false, true}) {
    auto scene = isFirst ? sceneOf({back, front}, {textured(0)}) : sceneOf({front, back}, {textured(0)});
    scene->textures.push_back(textureOf(256, 256, texels));
    for (const auto &[code, word] : voxelized(scene))
      EXPECT_EQ(word, kRed);
  }
}

TEST(VoxelMean, ANearerTriangleWithoutATextureTakesTheVoxel) {
  HandPart plain = grid(1, 0.5f);
  plain.material = 1;
  Material black;
  black.colour = {0, 0, 0, 1};
  auto scene = sceneOf({grid(8, 0.2f), plain, grid(8, 0.8f)}, {textured(0), black});
  scene->textures.push_back(filled(64, kRed));
  for (const auto &[code, word] : voxelized(scene))
    EXPECT_EQ(word, kBlack);
}

} // namespace
} // namespace voxc
