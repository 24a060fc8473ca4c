// Voxels of a size that is asked for, with planes through a point: meshes, points and scans.
#include "Input/InputTesting.h"

#include "voxc/Input/Input.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace voxc {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

class VoxelSizes : public OpenedInputs {
protected:
  glm::dvec3 toModel(double x, double y, double z) const { return map_ * glm::dvec4(x, y, z, 1); }
};

/// A square of 1 x 0.5 from (0.1, 0.2, 0.3) on.
const std::string kSquare = "v 0.1 0.2 0.3\nv 1.1 0.2 0.3\nv 1.1 0.7 0.3\nv 0.1 0.7 0.3\nf 1 2 3 4\n";

TEST_F(VoxelSizes, OfMeshesIsExact) {
  options_.voxelSize = {0.125, 0};
  EXPECT_FALSE(voxels("a.obj", kSquare).empty());
  EXPECT_EQ(extent_, (Int3{8, 4, 1}));
  EXPECT_EQ(toModel(0, 0, 0), glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_NEAR(toModel(8, 0, 0).x, 1.1, 1e-12);
  EXPECT_THAT(provenance_, HasSubstr("voxel-size=0.125"));
  // Planes go through multiples of the size, beginning at the origin.
  options_.align = {{0, 0, 0}};
  voxels("a.obj", kSquare);
  EXPECT_EQ(extent_, (Int3{9, 5, 1}));
  EXPECT_EQ(toModel(0, 0, 0), glm::dvec3(0, 0.125, 0.25));
  EXPECT_THAT(provenance_, HasSubstr("align=0,0,0"));
  // Also by a resolution alone, and where the model is turned.
  options_.voxelSize = {};
  options_.resolution = 4;
  options_.zUp = true;
  voxels("a.obj", kSquare);
  const glm::dvec3 low = toModel(0, 0, 0) / 0.25;
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(low[axis], std::round(low[axis]), 1e-9);
}

TEST_F(VoxelSizes, MeansOfSamplesThatReachTheThresholdReachIt) {
  for (const int value : {255, 7, 3}) {
    options_.threshold = value;
    options_.voxelSize = {0.7, 0};
    const std::string path = folder_.file("full.raw", std::string(512, static_cast<char>(value)));
    EXPECT_EQ(take(openInput("raw:8x8x8:uint8:" + path, options_)).size(), 11u * 11 * 11) << value;
    options_.voxelSize = {2.3, 0};
    EXPECT_EQ(take(openInput("raw:8x8x8:uint8:" + path, options_)).size(), 4u * 4 * 4) << value;
  }
}

TEST_F(VoxelSizes, MeansAreSoWhateverTheThreshold) {
  std::string ramp;
  for (int i = 0; i < 64; ++i)
    ramp += static_cast<char>(i);
  const std::string input = "raw:4x4x4:uint8:" + folder_.file("ramp.raw", ramp);
  options_.voxelSize = {2, 0};
  options_.window = {{0, 63}};
  options_.threshold = -1;
  const Voxels expected = take(openInput(input, options_));
  EXPECT_EQ(expected.size(), 8u);
  for (const double least : {-1e20, -1e300, -std::numeric_limits<double>::infinity()}) {
    options_.threshold = least;
    EXPECT_EQ(take(openInput(input, options_)), expected) << least;
  }
}

TEST_F(VoxelSizes, HaveUnits) {
  options_.voxelSize = *parseLength("25 cm");
  EXPECT_THAT(problem("a.obj", kSquare), HasSubstr("does not say how long its unit is"));
  options_.unit = *metresOf("ft");
  voxels("a.obj", kSquare);
  EXPECT_NEAR(glm::dvec3(map_[0]).x, 0.25 / 0.3048, 1e-12);
  options_.unit = 1;
  voxels("a.obj", kSquare);
  EXPECT_EQ(extent_, (Int3{4, 2, 1}));
  EXPECT_EQ(parseLength("0.05m")->metres, 1);
  EXPECT_EQ(parseLength("2in")->metres, 0.0254);
  EXPECT_EQ(parseLength("2")->metres, 0);
  for (const char *const none : {"", "m", "0", "-1mm", "1 parsec", "1,1,2", "nan", "inf"})
    EXPECT_FALSE(parseLength(none)) << none;
}

TEST_F(VoxelSizes, OfPoints) {
  const std::string points = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                             "property float z\nend_header\n0 0 0\n1 0.5 0\n";
  options_.voxelSize = {0.25, 0};
  EXPECT_EQ(voxels("a.ply", points),
            (Voxels{{mortonCode({0, 0, 0}), 0xffffffff}, {mortonCode({3, 1, 0}), 0xffffffff}}));
  options_.formatExtent = {3, 3, 3};
  EXPECT_THAT(problem("a.ply", points), HasSubstr("with voxels of side 0.25 the model takes 4x2x1"));
}

/// A scan of steps 1 x 1 x 4.
std::string scan(const std::string &sizes, const std::string &samples) {
  return "NRRD0004\ntype: uint8\ndimension: 3\nencoding: raw\nspacings: 1 1 4\nspace units: \"mm\" \"mm\" "
         "\"mm\"\nsizes: " +
         sizes + "\n\n" + samples;
}

TEST_F(VoxelSizes, OfScansMakeCubes) {
  options_.isAutomatic = true;
  std::string ball;
  for (int z = 0; z < 8; ++z)
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x)
        ball += std::hypot(x - 15.5, y - 15.5, 4 * z - 14.0) < 14 ? '\1' : '\0';
  voxels("a.nrrd", scan("32 32 8", ball));
  EXPECT_EQ(extent_, (Int3{32, 32, 8}));
  EXPECT_THAT(
      warnings_,
      Contains("its voxels are 1 x 1 x 4 and no cubes: pictures, pages, .glb, .nvdb, .vdb "
               "and .vti files keep that, all else shows it squashed; --voxel-size 1 makes cubes of them"));
  options_.voxelSize = *parseLength("1mm");
  const Voxels cubes = voxels("a.nrrd", scan("32 32 8", ball));
  EXPECT_EQ(extent_, (Int3{32, 32, 32}));
  EXPECT_THAT(warnings_, testing::Not(Contains(HasSubstr("no cubes"))));
  // Each sample is four cubes.
  Voxels expected;
  for (int z = 0; z < 32; ++z)
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x)
        if (ball[static_cast<std::size_t>(x + 32 * (y + 32 * (z / 4)))] != 0)
          expected[mortonCode({x, y, z})] = cubes.begin()->second;
  EXPECT_EQ(cubes, expected);
  EXPECT_THAT(provenance_, HasSubstr("voxel-size=1"));
}

TEST_F(VoxelSizes, SamplesAreMeansAndBetweenOthers) {
  options_.threshold = 1;
  options_.window = {{0, 255}};
  // 0 and 200 at heights 2 and 6: between them it goes up by 50 a step.
  options_.voxelSize = {1, 0};
  const auto grey = [](std::uint32_t value) { return rgba(value, value, value); };
  Voxels found = voxels("a.nrrd", scan("1 1 2", std::string("\0\310", 2)));
  EXPECT_EQ(extent_, (Int3{1, 1, 8}));
  const std::vector<std::uint32_t> heights{0, 0, 25, 75, 125, 175, 200, 200};
  for (int z = 0; z < 8; ++z)
    EXPECT_EQ(found[mortonCode({0, 0, z})],
              heights[static_cast<std::size_t>(z)] == 0 ? 0 : grey(heights[std::size_t(z)]));
  // A larger cube is the mean of what it covers: here half of one sample and all of the others.
  options_.voxelSize = {4, 0};
  found = voxels("a.nrrd", scan("6 1 1", std::string("\12\24\36\50\100\200", 6)));
  EXPECT_EQ(extent_, (Int3{2, 1, 1}));
  EXPECT_EQ(found, (Voxels{{mortonCode({0, 0, 0}), grey(25)}, {mortonCode({1, 0, 0}), grey(96)}}));
  options_.align = {{2, 0, 0}};
  found = voxels("a.nrrd", scan("6 1 1", std::string("\12\24\36\50\100\200", 6)));
  EXPECT_EQ(found, (Voxels{{mortonCode({0, 0, 0}), grey(15)}, {mortonCode({1, 0, 0}), grey(66)}}));
  EXPECT_EQ(toModel(0, 0, 0), glm::dvec3(-2, 0, 0));
}

TEST_F(VoxelSizes, OfScansThatDoNotFitAreErrors) {
  options_.voxelSize = {0.001, 0};
  EXPECT_THAT(problem("a.nrrd", scan("1 1 2", "ab")),
              HasSubstr("it takes 1000x1000x8000 voxels, but the format holds"));
  options_.voxelSize = {};
  options_.align = {{0, 0, 0}};
  EXPECT_THAT(problem("a.nrrd", scan("1 1 2", "ab")), HasSubstr("--align needs --voxel-size here"));
}

} // namespace
} // namespace voxc
