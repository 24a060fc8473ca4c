// Models with known colours and sizes, from their files to voxels.
#include "SharedModels.h"
#include "Source/SourceTesting.h"

#include "voxc/Mesh/MeshSource.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace voxc {
namespace {

struct Model {
  std::shared_ptr<const TriangleScene> scene;
  Voxels voxels;
};

/// The voxels of a shared model, which the reference confirms.
Model voxelized(const std::string &name, int resolution, Coverage coverage = Coverage::Conservative,
                ColourRule colour = ColourRule::Mean) {
  const auto memory = WorkingMemory::create(std::uint64_t{64} << 20);
  auto scene = loadScene(sharedModel(name), memory);
  EXPECT_TRUE(scene) << scene.error().message;
  if (!scene)
    return {};
  Model model{std::make_shared<const TriangleScene>(std::move(*scene)), {}};
  VoxelizeOptions options;
  options.resolution = resolution;
  options.coverage = coverage;
  options.colour = colour;
  auto source = makeMeshSource(model.scene, options, memory);
  auto reference = makeReferenceMeshSource(*model.scene, options);
  EXPECT_TRUE(source && reference);
  if (!source || !reference)
    return model;
  model.voxels = voxelsOf(**source);
  EXPECT_EQ(voxelsOf(**reference), model.voxels);
  return model;
}

TEST(Models, CubeOfVertexColours) {
  VOXC_SKIP_WITHOUT("cube_with_vertexcolors.obj");
  Voxels voxels = voxelized("cube_with_vertexcolors.obj", 64).voxels;
  // The corner (0, 0, 0) is 0.48627 0.43137 0.47059: 124, 110, 120. The voxel's centre is half a voxel away.
  const std::uint32_t corner = voxels[mortonCode({0, 0, 0})];
  EXPECT_NEAR(corner & 255, 124, 2);
  EXPECT_NEAR(corner >> 8 & 255, 110, 2);
  EXPECT_NEAR(corner >> 16 & 255, 120, 2);
  EXPECT_EQ(voxels.size(), 64u * 64 * 64 - 62 * 62 * 62);
}

/// The byte in sRGB of linear light.
double encoded(double light) {
  return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
}

/// Both files have the same numbers, which are linear light in a .glb and colours as they are in a .ply.
TEST(Models, SpotIsTheSameAsGlbAndPlyButForTheMeaningOfColours) {
  VOXC_SKIP_WITHOUT("spot_vertex_colors.glb");
  const Voxels plain = voxelized("spot_vertex_colors.ply", 48).voxels;
  EXPECT_GT(plain.size(), 1000u);
  const Voxels linear = voxelized("spot_vertex_colors.glb", 48).voxels;
  ASSERT_EQ(linear.size(), plain.size());
  for (const auto &[code, word] : plain)
    for (int bit = 0; bit < 24; bit += 8) {
      const double light = (word >> bit & 255) / 255.0;
      const double found = linear.at(code) >> bit & 255;
      EXPECT_GE(found, std::floor(encoded(light - 0.5 / 255)));
      EXPECT_LE(found, std::ceil(encoded(std::min(light + 0.5 / 255, 1.0))));
    }
}

TEST(Models, ThinSpotHasFewerVoxels) {
  VOXC_SKIP_WITHOUT("spot_vertex_colors.ply");
  const Voxels voxels = voxelized("spot_vertex_colors.ply", 64).voxels;
  const Voxels thin = voxelized("spot_vertex_colors.ply", 64, Coverage::Thin).voxels;
  EXPECT_LT(thin.size(), voxels.size());
  EXPECT_GT(thin.size(), voxels.size() / 2);
}

TEST(Models, BoxTexturedShowsItsTexture) {
  VOXC_SKIP_WITHOUT("BoxTextured.glb");
  const Model model = voxelized("BoxTextured.glb", 32, Coverage::Conservative, ColourRule::Nearest);
  EXPECT_EQ(model.voxels.size(), 32u * 32 * 32 - 30 * 30 * 30);
  ASSERT_EQ(model.scene->textures.size(), 1u);
  const auto texels = model.scene->textures[0].texels->span();
  const std::set<std::uint32_t> colours(texels.begin(), texels.end());
  for (const auto &[code, word] : model.voxels)
    EXPECT_TRUE(colours.contains(word));
  // The mean of several texels is another colour, and the shape is the same.
  const Voxels means = voxelized("BoxTextured.glb", 32).voxels;
  ASSERT_EQ(means.size(), model.voxels.size());
  std::size_t others = 0;
  for (const auto &[code, word] : means)
    others += word != model.voxels.at(code);
  EXPECT_GT(others, 100u);
}

} // namespace
} // namespace voxc
