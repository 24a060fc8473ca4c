// Textures whose texels are finer than voxels: means over what a voxel covers, beside sums by the definition.
#include "Mesh/Voxelize/TexelBox.h"

#include "SceneTesting.h"
#include "Source/SourceTesting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace voxc {
namespace {

using test::HandPart;
using test::sceneOf;
using test::textureOf;
using Wraps = std::array<TextureWrap, 2>;

constexpr std::uint32_t kBlack = rgba(0, 0, 0);
constexpr std::uint32_t kWhite = rgba(255, 255, 255);

double lightOf(std::uint32_t byte) {
  const double value = byte / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double byteOf(double light) {
  return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
}

std::shared_ptr<WorkingMemory> memory() { return WorkingMemory::create(std::uint64_t{16} << 20); }

TextureMeans meansOf(const Texture &texture, bool isOpaque) {
  auto means = TextureMeans::of(texture, isOpaque, memory(), {});
  EXPECT_TRUE(means);
  return std::move(*means);
}

/// The texel column or row under one place, in texels.
int wrapped(double place, int size, TextureWrap wrap) {
  const int index = static_cast<int>(std::floor(place));
  if (wrap == TextureWrap::ClampToEdge)
    return std::clamp(index, 0, size - 1);
  const int period = wrap == TextureWrap::Repeat ? size : 2 * size;
  const int inside = (index % period + period) % period;
  return inside < size ? inside : 2 * size - 1 - inside;
}

/// The mean over a box whose sides are at quarters of texels, by looking at each quarter.
std::array<double, 3> meanByDefinition(const Texture &texture, const Wraps &wrap, const TexelBox &box,
                                       bool isOpaque) {
  std::array<double, 3> sum{};
  double weight = 0;
  for (double y = box.low[1] + 0.125; y < box.high[1]; y += 0.25)
    for (double x = box.low[0] + 0.125; x < box.high[0]; x += 0.25) {
      const int column = wrapped(x, texture.width, wrap[0]);
      const int row = wrapped(y, texture.height, wrap[1]);
      const std::uint32_t texel = (*texture.texels)[static_cast<std::uint64_t>(row * texture.width + column)];
      const double alpha = isOpaque ? 1 : (texel >> 24) / 255.0;
      weight += alpha;
      for (std::size_t i = 0; i < 3; ++i)
        sum[i] += alpha * lightOf(texel >> 8 * i & 255);
    }
  for (double &channel : sum)
    channel = byteOf(channel / weight);
  return sum;
}

TEST(TextureMeans, LevelsAreMeansByArea) {
  // Three by two texels: the second column of the first level has one texel a row.
  const Texture texture = textureOf(3, 2, {kWhite, kBlack, kWhite, kBlack, kBlack, kBlack});
  const TextureMeans means = meansOf(texture, true);
  ASSERT_EQ(means.levels(), 2);
  EXPECT_EQ(means.cell(1, 0, 0)[0], 16384);
  EXPECT_EQ(means.cell(1, 1, 0)[0], 32768);
  // A third of all texels, and not the mean of a quarter and a half.
  EXPECT_NEAR(means.cell(2, 0, 0)[0], 65535 / 3.0, 1);
}

TEST(TextureMeans, BoxesAreWhatTheDefinitionSays) {
  std::mt19937 random(5);
  const auto between = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  BoxMeans boxMeans;
  for (int round = 0; round < 300; ++round) {
    const int width = between(1, 9);
    const int height = between(1, 9);
    std::vector<std::uint32_t> texels;
    for (int i = 0; i < width * height; ++i)
      texels.push_back(static_cast<std::uint32_t>(random()) | 0x01000000);
    const Texture texture = textureOf(width, height, texels);
    const bool isOpaque = random() % 2 == 0;
    const TextureMeans means = meansOf(texture, isOpaque);
    const Wraps wrap{static_cast<TextureWrap>(random() % 3), static_cast<TextureWrap>(random() % 3)};
    // Up to 3 x 3 texels, which no level but that of the texels is taken for.
    TexelBox box;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      box.low[axis] = between(-60, 60) / 4.0;
      box.high[axis] = box.low[axis] + between(1, 12) / 4.0;
    }
    const auto mean = boxMeans.of(means, wrap, box);
    ASSERT_TRUE(mean);
    const auto expected = meanByDefinition(texture, wrap, box, isOpaque);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(*mean >> 8 * i & 255, expected[i], 0.6) << round;
  }
}

TEST(TextureMeans, LargeBoxesAndLongOnes) {
  std::mt19937 random(6);
  std::vector<std::uint32_t> texels;
  for (int i = 0; i < 200 * 100; ++i)
    texels.push_back(rgba(100 + random() % 64, i % 200, i / 200));
  const Texture texture = textureOf(200, 100, texels);
  const TextureMeans means = meansOf(texture, false);
  BoxMeans boxMeans;
  const Wraps wrap{TextureWrap::Repeat, TextureWrap::MirroredRepeat};
  for (const TexelBox &box :
       {TexelBox{{0, 0}, {200, 100}}, TexelBox{{-200, 0}, {200, 200}}, TexelBox{{150, 20}, {250, 60}},
        TexelBox{{10, 30}, {190, 31}}, TexelBox{{77, -64}, {79, 64}}, TexelBox{{-50, 10}, {450, 370}},
        TexelBox{{-3000, 0}, {7000, 20}}}) {
    const auto mean = boxMeans.of(means, wrap, box);
    ASSERT_TRUE(mean);
    const auto expected = meanByDefinition(texture, wrap, box, false);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(*mean >> 8 * i & 255, expected[i], 3);
  }
}

TEST(TextureMeans, WhatIsInvisibleOrNowhereHasNone) {
  BoxMeans boxMeans;
  const Wraps wrap{};
  const Texture clear = textureOf(2, 1, {rgba(9, 9, 9, 0), rgba(9, 9, 9, 0)});
  EXPECT_FALSE(boxMeans.of(meansOf(clear, false), wrap, {{0, 0}, {2, 1}}));
  EXPECT_TRUE(boxMeans.of(meansOf(clear, true), wrap, {{0, 0}, {2, 1}}));
  // A line has the colour of its texels.
  EXPECT_EQ(boxMeans.of(meansOf(textureOf(2, 1, {kWhite, kBlack}), true), wrap, {{1.5, 0}, {1.5, 1}}), 0u);
}

/// A square of eight voxels a side in the plane z, over all of a texture.
HandPart square(float scale = 1) {
  return {{{0, 0, 0.5f}, {8, 0, 0.5f}, {8, 8, 0.5f}, {0, 8, 0.5f}},
          {0, 1, 2, 0, 2, 3},
          {{0, 0}, {scale, 0}, {scale, scale}, {0, scale}}};
}

Voxels voxelized(const std::shared_ptr<TriangleScene> &scene, ColourRule rule) {
  VoxelizeOptions options;
  options.resolution = 8;
  options.bounds = {{0, 0, 0, 8, 8, 8}};
  options.colour = rule;
  auto source = makeMeshSource(scene, options, memory());
  auto reference = makeReferenceMeshSource(*scene, options);
  EXPECT_TRUE(source && reference);
  const Voxels voxels = voxelsOf(**source);
  EXPECT_EQ(voxelsOf(**reference), voxels);
  return voxels;
}

std::shared_ptr<TriangleScene> textured(HandPart part, Texture texture, Material material = {}) {
  material.texture.texture = 0;
  auto scene = sceneOf({std::move(part)}, {material});
  scene->textures.push_back(std::move(texture));
  return scene;
}

/// A black line in each `period` rows of white, `size` texels a side.
Texture lines(int size, int period) {
  std::vector<std::uint32_t> texels;
  for (int i = 0; i < size * size; ++i)
    texels.push_back(i / size % period == 0 ? kBlack : kWhite);
  return textureOf(size, size, texels);
}

TEST(TextureMeans, LinesFinerThanVoxelsBecomeTheirMean) {
  // 32 texels a voxel. A sixteenth of all light is missing: 248 of 255.
  const auto scene = textured(square(), lines(256, 16));
  for (const auto &[code, word] : voxelized(scene, ColourRule::Mean))
    EXPECT_NEAR(word & 255, 248, 1);
  for (const auto &[code, word] : voxelized(scene, ColourRule::Nearest))
    EXPECT_EQ(word, kBlack);
  // The coordinates may do what the texture does not.
  const auto repeated = textured(square(16), lines(16, 16));
  for (const auto &[code, word] : voxelized(repeated, ColourRule::Mean))
    EXPECT_NEAR(word & 255, 248, 1);
}

TEST(TextureMeans, TexelsAsLargeAsVoxelsStayWhatTheyAre) {
  for (const int size : {1, 4, 8}) {
    std::vector<std::uint32_t> texels;
    for (int i = 0; i < size * size; ++i)
      texels.push_back(rgba(17 * i % 256, i, 255 - i));
    const auto scene = textured(square(), textureOf(size, size, texels));
    const Voxels voxels = voxelized(scene, ColourRule::Mean);
    EXPECT_EQ(voxels, voxelized(scene, ColourRule::Nearest));
    EXPECT_EQ(voxels.at(mortonCode({7, 7, 0})), texels.back());
  }
}

TEST(TextureMeans, HolesStayWhereTheNearestTexelHasThem) {
  // Two texels a voxel along x, of which the second, under the middle, is red; the first is invisible green.
  std::vector<std::uint32_t> texels;
  for (int i = 0; i < 16 * 16; ++i)
    texels.push_back(i % 2 == 1 ? rgba(255, 0, 0, 200) : rgba(0, 255, 0, 0));
  const auto scene = textured(square(), textureOf(16, 16, texels));
  const Voxels nearest = voxelized(scene, ColourRule::Nearest);
  EXPECT_EQ(nearest.size(), 64u);
  EXPECT_EQ(voxelized(scene, ColourRule::Mean), nearest);
  // Where alpha means nothing, the green counts.
  scene->materials[0].alpha = AlphaRule::Opaque;
  for (const auto &[code, word] : voxelized(scene, ColourRule::Mean))
    EXPECT_EQ(word, rgba(188, 188, 0));
}

TEST(TextureMeans, EmissionIsAveragedToo) {
  auto scene = textured(square(), lines(256, 16));
  scene->materials[0].colour = {0, 0, 0, 1};
  scene->materials[0].isLinear = true;
  scene->materials[0].emission = {1, 1, 1};
  scene->materials[0].emissionTexture.texture = 0;
  scene->parts[0].emissionUvs = scene->parts[0].uvs;
  for (const auto &[code, word] : voxelized(scene, ColourRule::Mean))
    EXPECT_NEAR(word & 255, 248, 1);
}

TEST(TextureMeans, NoTexelBeyondTheTriangleCounts) {
  // The square has the left half of an atlas, whose right half is black.
  std::vector<std::uint32_t> texels;
  for (int i = 0; i < 64 * 64; ++i)
    texels.push_back(i % 64 < 32 ? kWhite : kBlack);
  HandPart part = square();
  for (auto &uv : part.uvs)
    uv[0] /= 2;
  for (const auto &[code, word] : voxelized(textured(part, textureOf(64, 64, texels)), ColourRule::Mean))
    EXPECT_EQ(word, kWhite);
}

TEST(TextureMeans, BrokenCoordinatesTakeTheNearestTexel) {
  HandPart part = square();
  part.uvs.assign(4, {NAN, std::numeric_limits<float>::infinity()});
  for (const auto &[code, word] : voxelized(textured(part, lines(256, 16)), ColourRule::Mean))
    EXPECT_EQ(word, kBlack);
  part.uvs = {{0, 0}, {3e38f, 0}, {3e38f, -3e38f}, {0, 3e38f}};
  EXPECT_EQ(voxelized(textured(part, lines(256, 16)), ColourRule::Mean).size(), 64u);
}

} // namespace
} // namespace voxc
