// Volumes that are written as MagicaVoxel files, and read again.
#include "Source/SourceTesting.h"

#include "voxc/Input/Input.h"
#include "voxc/Source/Export.h"

#include <gtest/gtest.h>

#include <random>

namespace voxc {
namespace {

class MagicaVoxelExport : public testing::Test {
protected:
  TemporaryFolder folder_;
  InputOptions options_;
};

TEST_F(MagicaVoxelExport, ExportsComeBackAsTheyWere) {
  std::mt19937 random(8);
  options_.formatExtent = {1024, 1024, 1024};
  for (const Int3 extent :
       {Int3{1, 1, 1}, Int3{13, 8, 5}, Int3{300, 7, 3}, Int3{3, 270, 513}, Int3{8, 2, 257}})
    for (const int count : {0, 1, 40}) {
      Voxels voxels;
      for (int i = 0; i < count; ++i) {
        const auto coordinate = [&](int size) {
          return static_cast<int>(random() % static_cast<unsigned>(size));
        };
        voxels[mortonCode({coordinate(extent.x), coordinate(extent.y), coordinate(extent.z)})] =
            (random() % 100) << 24 | 5;
      }
      const std::string path = folder_.path("out.vox");
      ASSERT_TRUE(exportVoxels(denseVolume(voxels, extent), path));
      auto input = openInput(path, options_);
      ASSERT_TRUE(input) << input.error().message;
      EXPECT_EQ(voxelsOf(*input->source), voxels);
      EXPECT_EQ(input->source->extent(), extent);
    }
}

TEST_F(MagicaVoxelExport, AFileForEachCubeHasColoursOfItsOwn) {
  options_.formatExtent = {2048, 2048, 2048};
  Voxels voxels;
  for (int i = 0; i < 200; ++i) {
    voxels[mortonCode({i, 3, 1})] = 0xff000001 + static_cast<std::uint32_t>(i);
    voxels[mortonCode({1030 + i, 3, 1})] = 0xffff0001 + static_cast<std::uint32_t>(i);
  }
  const Int3 extent{1400, 5, 2};
  EXPECT_FALSE(exportVoxels(denseVolume(voxels, extent), folder_.path("one.vox")));
  const auto exported = exportVoxels(denseVolume(voxels, extent), folder_.path("part%d.vox"));
  ASSERT_TRUE(exported) << exported.error().message;
  EXPECT_EQ(exported->files, 2u);
  auto input = openInput(folder_.path("part%d.vox"), options_);
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(voxelsOf(*input->source), voxels);
  EXPECT_EQ(input->source->extent(), extent);
  // Of nothing there is one file, which keeps the extent.
  ASSERT_EQ(exportVoxels(denseVolume({}, extent), folder_.path("none%d.vox"))->files, 1u);
  input = openInput(folder_.path("none%d.vox"), options_);
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(input->source->extent(), extent);
}

TEST_F(MagicaVoxelExport, LossyColoursAreNearTheirOwn) {
  Voxels voxels;
  for (int i = 0; i < 400; ++i)
    voxels[mortonCode({i % 20, i / 20, 0})] = rgba(static_cast<std::uint32_t>(i) / 2, 9, 9);
  voxels[mortonCode({0, 0, 1})] = rgba(250, 250, 250);
  const Volume volume = denseVolume(voxels, {20, 20, 2});
  EXPECT_TRUE(exportVoxels(volume, folder_.path("few.vox"), {.lossy = true}));
  Voxels many = voxels;
  for (int i = 0; i < 400; ++i)
    many[mortonCode({i % 20, i / 20, 1})] = rgba(9, static_cast<std::uint32_t>(i) / 2, 77);
  EXPECT_FALSE(exportVoxels(denseVolume(many, {20, 20, 2}), folder_.path("many.vox")));
  const auto exported =
      exportVoxels(denseVolume(many, {20, 20, 2}), folder_.path("many.vox"), {.lossy = true});
  ASSERT_TRUE(exported) << exported.error().message;
  ASSERT_TRUE(exported->loss);
  auto input = openInput(folder_.path("many.vox"), options_);
  ASSERT_TRUE(input) << input.error().message;
  ColourErrorSum sum;
  for (const auto &[code, word] : voxelsOf(*input->source))
    sum.add(many[code], word);
  EXPECT_EQ(sum.error().largest, exported->loss->largest);
  EXPECT_EQ(sum.error().rms, exported->loss->rms);
  EXPECT_EQ(sum.error().voxels, 800u);
  EXPECT_LE(sum.error().largest[1], 8);
  EXPECT_GT(sum.error().largest[1], 0);
}

} // namespace
} // namespace voxc
