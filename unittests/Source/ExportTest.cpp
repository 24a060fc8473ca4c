// Exports come back as they were, and a failed one leaves nothing behind.
#include "SourceTesting.h"

#include "voxc/Input/Input.h"
#include "voxc/Source/Export.h"
#include "voxc/Volume/LabelColour.h"

#include <random>
#include <set>

namespace voxc {
namespace {

/// Of an input that takes less than its format holds.
Volume makeVolume(const Voxels &voxels) { return denseVolume(voxels, {13, 8, 5}); }

Voxels randomVoxels(unsigned colours) {
  std::mt19937 random(5);
  Voxels voxels;
  for (unsigned i = 0; i < 300; ++i)
    voxels[mortonCode({static_cast<int>(random() % 13), static_cast<int>(random() % 8),
                       static_cast<int>(random() % 5)})] = rgba(i % colours, 7, 9);
  return voxels;
}

std::string contentOf(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Export, GridComesBack) {
  const TemporaryFolder folder;
  const Voxels voxels = randomVoxels(200);
  const std::string path = folder.path("v.raw");
  const auto written = exportVoxels(makeVolume(voxels), path);
  ASSERT_TRUE(written) << written.error().message;
  EXPECT_EQ(std::filesystem::file_size(path), 13u * 8 * 5 * 4);
  auto input = openInput("grid:13x8x5:" + path, {});
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(voxelsOf(*input->source), voxels);
}

TEST(Export, PointsComeBack) {
  const TemporaryFolder folder;
  const Voxels voxels = randomVoxels(200);
  ASSERT_TRUE(exportVoxels(makeVolume(voxels), folder.path("v.PLY")));
  auto input = openInput(folder.path("v.PLY"), {});
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(voxelsOf(*input->source), voxels);
  EXPECT_EQ(input->provenance, "coverage=indices");
}

TEST(Export, LabelsOfAVoxFileDifferInColour) {
  std::set<std::uint32_t> colours;
  for (std::uint32_t label = 1; label <= 255; ++label)
    colours.insert(labelColour(label));
  EXPECT_EQ(colours.size(), 255u);
}

TEST(Export, EmptyVolumeIsExported) {
  const TemporaryFolder folder;
  VolumeInfo info;
  info.format = *parseFormat("R(1, 1, 1)");
  info.extent = {2, 2, 2};
  for (const char *name : {"v.raw", "v.ply", "v.vox"})
    EXPECT_TRUE(exportVoxels(Volume(info, {0}), folder.path(name))) << name;
  auto input = openInput(folder.path("v.ply"), {});
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_TRUE(voxelsOf(*input->source).empty());
}

TEST(Export, MagicaVoxelStandsUpright) {
  const TemporaryFolder folder;
  const std::string path = folder.path("v.vox");
  ASSERT_TRUE(exportVoxels(makeVolume({{mortonCode({12, 7, 0}), rgba(1, 2, 3)}}), path));
  const std::string bytes = contentOf(path);
  EXPECT_EQ(bytes.substr(0, 8), std::string("VOX \226\0\0\0", 8));
  // x, then -z, then y.
  EXPECT_NE(bytes.find(std::string("SIZE\14\0\0\0\0\0\0\0\15\0\0\0\5\0\0\0\10\0\0\0", 24)),
            std::string::npos);
  EXPECT_NE(bytes.find(std::string("XYZI\10\0\0\0\0\0\0\0\1\0\0\0\14\4\7\1", 20)), std::string::npos);
  EXPECT_NE(bytes.find(std::string("RGBA\0\4\0\0\0\0\0\0\1\2\3\377", 16)), std::string::npos);
  EXPECT_NE(bytes.find("6 2 4"), std::string::npos);
}

TEST(Export, FailureLeavesTheOldFileAndNothingElse) {
  const TemporaryFolder folder;
  const std::string path = folder.file("v.vox", "old");
  Voxels voxels;
  for (int i = 0; i < 256; ++i)
    voxels[mortonCode({i % 13, i / 13 % 8, i / 104})] = rgba(static_cast<std::uint32_t>(i), 0, 0);
  const auto written = exportVoxels(makeVolume(voxels), path);
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().message.find("255 colours"), std::string::npos);
  EXPECT_EQ(contentOf(path), "old");
  EXPECT_EQ(folder.count(), 1);

  EXPECT_FALSE(exportVoxels(makeVolume({}), folder.path("v.png")));
  EXPECT_FALSE(exportVoxels(makeVolume({}), folder.path("no/such/folder.raw")));
  EXPECT_EQ(folder.count(), 1);
}

} // namespace
} // namespace voxc
