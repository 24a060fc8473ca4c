// Colours of voxels: which triangle gives them, materials, textures, wrapping and cut-outs.
#include "SceneTesting.h"
#include "Source/SourceTesting.h"

#include <cmath>
#include <limits>

namespace voxc {
namespace {

using test::HandPart;
using test::sceneOf;
using test::textureOf;

constexpr std::uint32_t kRed = rgba(255, 0, 0);
constexpr std::uint32_t kGreen = rgba(0, 255, 0);
constexpr std::uint32_t kBlue = rgba(0, 0, 255);
constexpr std::uint32_t kGrey = rgba(9, 9, 9);

Voxels voxelized(const std::shared_ptr<TriangleScene> &scene) {
  VoxelizeOptions options;
  options.resolution = 8;
  options.bounds = {{0, 0, 0, 8, 8, 8}};
  auto source = makeMeshSource(scene, options, WorkingMemory::create(1 << 20));
  auto reference = makeReferenceMeshSource(*scene, options);
  EXPECT_TRUE(source) << source.error().message;
  EXPECT_TRUE(reference) << reference.error().message;
  if (!source || !reference)
    return {};
  const Voxels voxels = voxelsOf(**source);
  EXPECT_EQ(voxelsOf(**reference), voxels);
  return voxels;
}

Material coloured(float r, float g, float b, float a = 1) {
  Material material;
  material.colour = {r, g, b, a};
  return material;
}

Material textured(int texture) {
  Material material;
  material.texture.texture = texture;
  return material;
}

/// A square in the plane z, from (0, 0) to (8, 8), whose texture coordinates run from (0, 0) to (1, 1).
HandPart square(float z, std::uint32_t material) {
  return {{{0, 0, z}, {8, 0, z}, {8, 8, z}, {0, 8, z}},
          {0, 1, 2, 0, 2, 3},
          {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
          {},
          material};
}

/// One triangle that covers that square and has texture coordinates to (4, 4), so that no diagonal crosses
/// it.
HandPart cover(float z) { return {{{0, 0, z}, {32, 0, z}, {0, 32, z}}, {}, {{0, 0}, {4, 0}, {0, 4}}}; }

void expectAll(const Voxels &voxels, std::uint32_t word) {
  EXPECT_EQ(voxels.size(), 64u);
  for (const auto &[code, found] : voxels)
    EXPECT_EQ(found, word);
}

TEST(SurfaceColour, NearestTriangleWins) {
  const std::vector<Material> materials{coloured(1, 0, 0), coloured(0, 1, 0)};
  expectAll(voxelized(sceneOf({square(0.45f, 0), square(0.499f, 1)}, materials)), kGreen);
  expectAll(voxelized(sceneOf({square(0.45f, 1), square(0.5f, 0)}, materials)), kRed);
}

TEST(SurfaceColour, LowestNumberWinsAmongEqualsInSpiteOfRounding) {
  HandPart second = square(0.3f, 1);
  std::swap(second.indices[0], second.indices[2]);
  expectAll(voxelized(sceneOf({square(0.3f, 0), second}, {coloured(1, 0, 0), coloured(0, 1, 0)})), kRed);
}

/// A voxel beyond an edge takes the nearest point, which lies on it: there a texture that repeats would begin
/// anew.
TEST(SurfaceColour, AtItsUpperEndATextureShowsItsLastTexel) {
  HandPart part = square(0.3f, 0);
  for (std::array<float, 3> &corner : part.positions)
    for (std::size_t axis = 0; axis < 2; ++axis)
      corner[axis] = corner[axis] * 7.3f / 8;
  for (const TextureWrap wrap :
       {TextureWrap::Repeat, TextureWrap::MirroredRepeat, TextureWrap::ClampToEdge}) {
    auto scene = sceneOf({part}, {textured(0)});
    scene->materials[0].texture.wrap = {wrap, wrap};
    scene->textures.push_back(textureOf(2, 2, {kRed, kGreen, kBlue, kGrey}));
    const Voxels voxels = voxelized(scene);
    ASSERT_EQ(voxels.size(), 64u);
    EXPECT_EQ(voxels.at(mortonCode({0, 0, 0})), kRed);
    EXPECT_EQ(voxels.at(mortonCode({7, 0, 0})), kGreen);
    EXPECT_EQ(voxels.at(mortonCode({0, 7, 0})), kBlue);
    EXPECT_EQ(voxels.at(mortonCode({7, 7, 0})), kGrey);
  }
}

TEST(SurfaceColour, NumbersRunThroughInstances) {
  auto scene = sceneOf({square(0.3f, 0), square(0.3f, 1)}, {coloured(1, 0, 0), coloured(0, 1, 0)});
  std::swap(scene->instances[0], scene->instances[1]);
  expectAll(voxelized(scene), kGreen);
}

TEST(SurfaceColour, TextureIsSampledAtTheNearestPoint) {
  HandPart part = square(0.5f, 0);
  const Texture texture = textureOf(2, 2, {kRed, kGreen, kBlue, kGrey});
  const auto voxelsFor = [&] {
    auto scene = sceneOf({part}, {textured(0)});
    scene->textures.push_back(texture);
    return voxelized(scene);
  };
  Voxels voxels = voxelsFor();
  EXPECT_EQ(voxels[mortonCode({0, 0, 0})], kRed);
  EXPECT_EQ(voxels[mortonCode({4, 3, 0})], kGreen);
  EXPECT_EQ(voxels[mortonCode({3, 4, 0})], kBlue);
  EXPECT_EQ(voxels[mortonCode({7, 7, 0})], kGrey);
  for (auto &uv : part.uvs)
    uv = {uv[0] - 3, uv[1] + 2};
  EXPECT_EQ(voxelsFor(), voxels);
  part.uvs.assign(4, {NAN, std::numeric_limits<float>::infinity()});
  expectAll(voxelsFor(), kRed);
}

/// The colours of the lowest row of voxels under a texture of two texels, red and green, whose coordinates
/// run from -1 to 3: `r` and `g`.
std::string rowUnder(TextureWrap wrap) {
  HandPart part = cover(0.5f);
  part.uvs = {{-1, 0.5f}, {15, 0.5f}, {-1, 0.5f}};
  auto scene = sceneOf({part}, {textured(0)});
  scene->materials[0].texture.wrap = {wrap, wrap};
  scene->textures.push_back(textureOf(2, 1, {kRed, kGreen}));
  std::string row;
  for (const auto &[code, word] : voxelized(scene))
    if (mortonCell(code).y == 0)
      row += word == kRed ? 'r' : 'g';
  return row;
}

TEST(SurfaceColour, TexturesWrapAsTheyAreTold) {
  EXPECT_EQ(rowUnder(TextureWrap::Repeat), "rgrgrgrg");
  EXPECT_EQ(rowUnder(TextureWrap::MirroredRepeat), "grrggrrg");
  EXPECT_EQ(rowUnder(TextureWrap::ClampToEdge), "rrrggggg");
}

TEST(SurfaceColour, TextureMatrixMapsCoordinates) {
  auto scene = sceneOf({square(0.5f, 0)}, {textured(0)});
  scene->textures.push_back(textureOf(2, 2, {kRed, kGreen, kBlue, kGrey}));
  scene->materials[0].texture.matrix = {0, 1, 0.5f, 1, 0, 0};
  Voxels voxels = voxelized(scene);
  EXPECT_EQ(voxels[mortonCode({0, 0, 0})], kGreen);
  EXPECT_EQ(voxels[mortonCode({7, 0, 0})], kGrey);
  EXPECT_EQ(voxels[mortonCode({0, 7, 0})], kRed);
}

TEST(SurfaceColour, FactorsMultiply) {
  HandPart part = square(0.5f, 0);
  part.colours.assign(4, {1, 0.2f, 1, 1});
  Material material = textured(0);
  material.colour = {0.5f, 1, 1, 0.2f};
  auto scene = sceneOf({part}, {material});
  scene->textures.push_back(textureOf(1, 1, {rgba(200, 100, 50)}));
  expectAll(voxelized(scene), rgba(100, 20, 50, 51));
  // Colours of three components are opaque.
  scene->parts[0].colours.components = 3;
  expectAll(voxelized(scene), rgba(100, 20, 50, 51));
  scene->textures[0] = textureOf(1, 1, {rgba(200, 100, 50, 200)});
  expectAll(voxelized(scene), rgba(100, 20, 50, 51));
}

TEST(SurfaceColour, InvisibleAndBrokenColoursAreStillVoxels) {
  expectAll(voxelized(sceneOf({square(0.5f, 0)}, {coloured(0, 0, 0, 0)})), rgba(0, 0, 0, 1));
  expectAll(voxelized(sceneOf({square(0.5f, 0)}, {coloured(NAN, 2, -1, NAN)})), rgba(0, 255, 0, 1));
}

TEST(SurfaceColour, AlphaBelowTheCutoffCutsOut) {
  auto scene = sceneOf({cover(0.5f)}, {textured(0)});
  scene->textures.push_back(textureOf(2, 1, {rgba(9, 9, 9, 127), rgba(9, 9, 9, 128)}));
  const Voxels voxels = voxelized(scene);
  EXPECT_EQ(voxels.size(), 32u);
  for (const auto &[code, word] : voxels) {
    EXPECT_GE(mortonCell(code).x, 4);
    EXPECT_EQ(word, kGrey);
  }
  scene->materials[0].alphaCutoff = 0.25f;
  expectAll(voxelized(scene), kGrey);
  scene->materials[0].alphaCutoff = 0.75f;
  EXPECT_TRUE(voxelized(scene).empty());
  scene->materials[0].alpha = AlphaRule::Opaque;
  expectAll(voxelized(scene), kGrey);
}

TEST(SurfaceColour, AMaskHoldsAllAlphaAgainstTheCutoff) {
  HandPart part = square(0.5f, 0);
  part.colours.assign(4, {1, 1, 1, 0.5f});
  Material material = textured(0);
  material.colour[3] = 0.5f;
  material.alpha = AlphaRule::Mask;
  material.alphaCutoff = 0.2f;
  auto scene = sceneOf({part}, {material});
  // 0.5 * 0.5 * 0.8 is 0.2, the cutoff itself; what is left is opaque.
  scene->textures.push_back(textureOf(1, 1, {rgba(9, 9, 9, 204)}));
  expectAll(voxelized(scene), kGrey);
  scene->textures[0] = textureOf(1, 1, {rgba(9, 9, 9, 203)});
  EXPECT_TRUE(voxelized(scene).empty());
  scene->materials[0].alpha = AlphaRule::Opaque;
  expectAll(voxelized(scene), kGrey);
}

TEST(SurfaceColour, WhatIsBlendedToNothingIsCutOut) {
  HandPart part = square(0.5f, 0);
  part.colours.assign(4, {1, 0, 0, 1});
  Material material;
  material.alpha = AlphaRule::Blend;
  material.colour[3] = 0.2f;
  auto scene = sceneOf({part}, {material});
  expectAll(voxelized(scene), rgba(255, 0, 0, 51));
  scene->materials[0].colour[3] = 0.001f;
  EXPECT_TRUE(voxelized(scene).empty());
  scene->parts[0].colours = {};
  EXPECT_TRUE(voxelized(scene).empty());
  // Vertices alone.
  part.colours.assign(4, {1, 0, 0, 0});
  scene = sceneOf({part}, {material});
  EXPECT_TRUE(voxelized(scene).empty());
  scene->materials[0].alpha = AlphaRule::Kept;
  expectAll(voxelized(scene), rgba(255, 0, 0, 1));
}

TEST(SurfaceColour, LinearNumbersBecomeSrgb) {
  Material material = coloured(0.5f, 0.0331f, 0.001f);
  material.isLinear = true;
  expectAll(voxelized(sceneOf({square(0.5f, 0)}, {material})), rgba(188, 51, 3));
  HandPart part = square(0.5f, 0);
  part.colours.assign(4, {0.25f, 1, 0.5f, 1});
  expectAll(voxelized(sceneOf({part}, {material})), rgba(99, 51, 2));
  // A texel is made linear first: half of the light of 188 is that of 137.
  material.texture.texture = 0;
  auto scene = sceneOf({square(0.5f, 0)}, {material});
  scene->textures.push_back(textureOf(1, 1, {rgba(188, 255, 255)}));
  expectAll(voxelized(scene), rgba(137, 51, 3));
  scene->materials[0].colour = {1, 1, 1, 1};
  expectAll(voxelized(scene), rgba(188, 255, 255));
}

TEST(SurfaceColour, EmissionIsAdded) {
  Material material = coloured(0, 0, 0.2f);
  material.emission = {1, 0.5f, 0.2f};
  expectAll(voxelized(sceneOf({square(0.5f, 0)}, {material})), rgba(255, 128, 102));
  material.isLinear = true;
  expectAll(voxelized(sceneOf({square(0.5f, 0)}, {material})), rgba(255, 188, 170));
  // The texture of emission has coordinates of its own.
  material.isLinear = false;
  material.texture.texture = 0;
  material.emissionTexture.texture = 1;
  auto scene = sceneOf({square(0.5f, 0)}, {material});
  scene->textures.push_back(textureOf(2, 1, {kGrey, rgba(0, 0, 255)}));
  scene->textures.push_back(textureOf(1, 2, {rgba(100, 0, 0), rgba(0, 200, 0)}));
  scene->parts[0].emissionUvs = scene->parts[0].uvs;
  Voxels voxels = voxelized(scene);
  EXPECT_EQ(voxels[mortonCode({0, 0, 0})], rgba(100, 0, 2));
  EXPECT_EQ(voxels[mortonCode({7, 0, 0})], rgba(100, 0, 51));
  EXPECT_EQ(voxels[mortonCode({7, 7, 0})], rgba(0, 100, 51));
  scene->parts[0].uvs = {};
  voxels = voxelized(scene);
  EXPECT_EQ(voxels[mortonCode({0, 0, 0})], rgba(100, 0, 51));
}

TEST(SurfaceColour, WhatIsCutOutHidesNothing) {
  auto scene = sceneOf({square(0.5f, 0), square(0.2f, 1)}, {textured(0), coloured(1, 0, 0)});
  scene->textures.push_back(textureOf(1, 1, {rgba(9, 9, 9, 0)}));
  expectAll(voxelized(scene), kRed);
}

TEST(SurfaceColour, MaskCutsOutByItsRed) {
  Material material = coloured(1, 0, 0);
  material.alphaMask.texture = 0;
  auto scene = sceneOf({cover(0.5f)}, {material});
  scene->textures.push_back(textureOf(1, 2, {rgba(255, 0, 0), rgba(0, 255, 255)}));
  const Voxels voxels = voxelized(scene);
  EXPECT_EQ(voxels.size(), 32u);
  for (const auto &[code, word] : voxels) {
    EXPECT_LT(mortonCell(code).y, 4);
    EXPECT_EQ(word, kRed);
  }
}

} // namespace
} // namespace voxc
