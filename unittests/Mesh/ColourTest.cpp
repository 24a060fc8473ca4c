// Colours of voxels: which triangle gives them, textures, cut-outs, and models with known colours.
#include "SharedModels.h"
#include "Source/SourceTesting.h"

#include "voxc/Mesh/Voxelizer.h"

#include <set>

namespace voxc {
namespace {

constexpr std::uint32_t kRed = rgba(255, 0, 0);
constexpr std::uint32_t kGreen = rgba(0, 255, 0);

/// A square in the plane z, from (0, 0) to (8, 8), whose texture coordinates run from (0, 0) to (1, 1).
void addSquare(TriangleMesh &mesh, float z, std::uint32_t material) {
  const auto base = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Float2 &corner : {Float2{0, 0}, Float2{8, 0}, Float2{8, 8}, Float2{0, 8}}) {
    mesh.positions.push_back({corner[0], corner[1], z});
    mesh.uvs.push_back({corner[0] / 8, corner[1] / 8});
  }
  mesh.triangles.push_back({{base, base + 1, base + 2}, material});
  mesh.triangles.push_back({{base, base + 2, base + 3}, material});
}

/// A triangle in the plane z that covers that square alone, so that no diagonal crosses it.
void addCover(TriangleMesh &mesh, float z) {
  mesh.positions = {{0, 0, z}, {32, 0, z}, {0, 32, z}};
  mesh.uvs = {{0, 0}, {4, 0}, {0, 4}};
  mesh.triangles.push_back({{0, 1, 2}, 0});
}

Voxels voxelized(const TriangleMesh &mesh, int resolution = 8) {
  VoxelizeOptions options;
  options.resolution = resolution;
  options.bounds = {{0, 0, 0, 8, 8, 8}};
  auto source = voxelize(mesh, options);
  EXPECT_TRUE(source) << source.error().message;
  return source ? voxelsOf(**source) : Voxels{};
}

TriangleMesh withMaterials(const std::vector<std::array<float, 4>> &colours) {
  TriangleMesh mesh;
  for (const auto &colour : colours)
    mesh.materials.push_back({colour});
  return mesh;
}

TEST(Colour, NearestTriangleWins) {
  TriangleMesh mesh = withMaterials({{1, 0, 0, 1}, {0, 1, 0, 1}});
  addSquare(mesh, 0.45f, 0);
  addSquare(mesh, 0.499f, 1);
  for (const auto &[code, word] : voxelized(mesh))
    EXPECT_EQ(word, kGreen);
}

TEST(Colour, LowestIndexWinsAmongEqualsInSpiteOfRounding) {
  TriangleMesh mesh = withMaterials({{1, 0, 0, 1}, {0, 1, 0, 1}});
  addSquare(mesh, 0.3f, 0);
  addSquare(mesh, 0.3f, 1);
  std::swap(mesh.triangles[2].vertices[0], mesh.triangles[2].vertices[2]);
  const Voxels voxels = voxelized(mesh);
  EXPECT_EQ(voxels.size(), 64u);
  for (const auto &[code, word] : voxels)
    EXPECT_EQ(word, kRed);
}

TEST(Colour, TextureIsSampledAtTheNearestPoint) {
  TriangleMesh mesh = withMaterials({{1, 1, 1, 1}});
  mesh.textures.push_back({2, 2, {kRed, kGreen, rgba(0, 0, 255), rgba(9, 9, 9)}});
  mesh.materials[0].texture = 0;
  addSquare(mesh, 0.5f, 0);
  Voxels voxels = voxelized(mesh);
  EXPECT_EQ(voxels[mortonCode({0, 0, 0})], kRed);
  EXPECT_EQ(voxels[mortonCode({4, 3, 0})], kGreen);
  EXPECT_EQ(voxels[mortonCode({3, 4, 0})], rgba(0, 0, 255));
  EXPECT_EQ(voxels[mortonCode({7, 7, 0})], rgba(9, 9, 9));
  for (Float2 &uv : mesh.uvs)
    uv = {uv[0] - 3, uv[1] + 2};
  EXPECT_EQ(voxelized(mesh), voxels);
}

TEST(Colour, FactorsMultiply) {
  TriangleMesh mesh = withMaterials({{0.5f, 1, 1, 0.2f}});
  mesh.textures.push_back({1, 1, {rgba(200, 100, 50)}});
  mesh.materials[0].texture = 0;
  addSquare(mesh, 0.5f, 0);
  mesh.colours.assign(4, rgba(255, 51, 255));
  EXPECT_EQ(voxelized(mesh).begin()->second, rgba(100, 20, 50, 51));
}

TEST(Colour, InvisibleMaterialIsStillAVoxel) {
  TriangleMesh mesh = withMaterials({{0, 0, 0, 0}});
  addSquare(mesh, 0.5f, 0);
  const Voxels voxels = voxelized(mesh);
  EXPECT_EQ(voxels.size(), 64u);
  EXPECT_EQ(voxels.begin()->second, rgba(0, 0, 0, 1));
}

TEST(Colour, AlphaBelowOneHalfCutsOut) {
  TriangleMesh mesh = withMaterials({{1, 1, 1, 1}});
  mesh.textures.push_back({2, 1, {rgba(9, 9, 9, 127), rgba(9, 9, 9, 128)}});
  mesh.materials[0].texture = 0;
  addCover(mesh, 0.5f);
  Voxels voxels = voxelized(mesh);
  EXPECT_EQ(voxels.size(), 32u);
  for (const auto &[code, word] : voxels) {
    EXPECT_GE(mortonCell(code).x, 4);
    EXPECT_EQ(word, rgba(9, 9, 9));
  }
  mesh.materials[0].opaque = true;
  EXPECT_EQ(voxelized(mesh).size(), 64u);
}

TEST(Colour, MaskCutsOutByItsRed) {
  TriangleMesh mesh = withMaterials({{1, 0, 0, 1}});
  mesh.textures.push_back({1, 2, {rgba(255, 0, 0), rgba(0, 255, 255)}});
  mesh.materials[0].alphaMask = 0;
  addCover(mesh, 0.5f);
  const Voxels voxels = voxelized(mesh);
  EXPECT_EQ(voxels.size(), 32u);
  for (const auto &[code, word] : voxels) {
    EXPECT_LT(mortonCell(code).y, 4);
    EXPECT_EQ(word, kRed);
  }
}

TEST(Colour, CubeOfVertexColours) {
  VOXC_SKIP_WITHOUT("cube_with_vertexcolors.obj");
  auto mesh = loadMesh(sharedModel("cube_with_vertexcolors.obj"));
  ASSERT_TRUE(mesh) << mesh.error().message;
  VoxelizeOptions options;
  options.resolution = 64;
  Voxels voxels = voxelsOf(**voxelize(*mesh, options));
  // The corner (0, 0, 0) is 0.48627 0.43137 0.47059: 124, 110, 120. The voxel's centre is half a voxel away.
  const std::uint32_t corner = voxels[mortonCode({0, 0, 0})];
  EXPECT_NEAR(corner & 255, 124, 2);
  EXPECT_NEAR(corner >> 8 & 255, 110, 2);
  EXPECT_NEAR(corner >> 16 & 255, 120, 2);
  EXPECT_EQ(voxels.size(), 64u * 64 * 64 - 62 * 62 * 62);
}

TEST(Colour, SpotIsTheSameAsGlbAndPly) {
  VOXC_SKIP_WITHOUT("spot_vertex_colors.glb");
  VoxelizeOptions options;
  options.resolution = 48;
  auto glb = loadMesh(sharedModel("spot_vertex_colors.glb"));
  auto ply = loadMesh(sharedModel("spot_vertex_colors.ply"));
  ASSERT_TRUE(glb) << glb.error().message;
  ASSERT_TRUE(ply) << ply.error().message;
  EXPECT_EQ(ply->triangles.size(), 5856u);
  const Voxels voxels = voxelsOf(**voxelize(*ply, options));
  EXPECT_GT(voxels.size(), 1000u);
  EXPECT_EQ(voxelsOf(**voxelize(*glb, options)), voxels);
}

TEST(Colour, BoxTexturedShowsItsTexture) {
  VOXC_SKIP_WITHOUT("BoxTextured.glb");
  auto mesh = loadMesh(sharedModel("BoxTextured.glb"));
  ASSERT_TRUE(mesh) << mesh.error().message;
  ASSERT_EQ(mesh->textures.size(), 1u);
  EXPECT_TRUE(mesh->warnings.empty());
  VoxelizeOptions options;
  options.resolution = 32;
  const Voxels voxels = voxelsOf(**voxelize(*mesh, options));
  EXPECT_EQ(voxels.size(), 32u * 32 * 32 - 30 * 30 * 30);
  const std::set<std::uint32_t> texels(mesh->textures[0].texels.begin(), mesh->textures[0].texels.end());
  for (const auto &[code, word] : voxels)
    EXPECT_TRUE(texels.contains(word));
}

} // namespace
} // namespace voxc
