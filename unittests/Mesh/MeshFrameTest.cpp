// Where voxels lie in the model, and scenes that cannot be voxelized.
#include "SceneTesting.h"
#include "Source/SourceTesting.h"

#include <atomic>
#include <cmath>

namespace voxc {
namespace {

using test::sceneOf;
using test::soupOf;
using Corner = std::array<float, 3>;
using Opened = Expected<std::unique_ptr<VoxelSource>>;

Opened open(const std::shared_ptr<TriangleScene> &scene, const VoxelizeOptions &options) {
  return makeMeshSource(scene, options, WorkingMemory::create(1 << 20));
}

Voxels voxelized(const std::shared_ptr<TriangleScene> &scene, const VoxelizeOptions &options) {
  auto source = open(scene, options);
  EXPECT_TRUE(source) << source.error().message;
  return source ? voxelsOf(**source) : Voxels{};
}

const std::vector<Corner> kUnitTriangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

TEST(MeshFrame, FarFaceIsKeptInTheLastVoxels) {
  // A box of 4 x 2 x 1: its faces lie on the faces of the extent.
  std::vector<Corner> corners;
  for (const float x : {-1.0f, 3.0f})
    corners.insert(corners.end(), {{x, 0, 0}, {x, 2, 0}, {x, 2, 1}});
  VoxelizeOptions options;
  options.resolution = 12;
  auto source = open(soupOf(corners), options);
  ASSERT_TRUE(source);
  EXPECT_EQ((*source)->extent(), (Int3{12, 6, 3}));
  int first = 0;
  int last = 0;
  for (const auto &[code, word] : voxelsOf(**source)) {
    first += mortonCell(code).x == 0;
    last += mortonCell(code).x == 11;
  }
  EXPECT_GT(first, 0);
  EXPECT_EQ(first, last);
}

TEST(MeshFrame, RoundingAddsNoVoxels) {
  // 2 x 1 x 0.5, turned by a quarter and back about two axes, as nodes of models may.
  std::vector<Corner> corners;
  for (const float x : {0.0f, 2.0f})
    corners.insert(corners.end(), {{x, 0, 0}, {x, 1, 0}, {x, 1, 0.5f}});
  for (const double leak : {2e-16, 1e-12, -1e-12}) {
    const auto scene = soupOf(corners);
    scene->instances[0].toModel = transformOfRows({1, leak, leak, 0, leak, 1, leak, 0, leak, leak, 1, 0});
    for (const auto &[resolution, extent] :
         {std::pair{16, Int3{16, 8, 4}}, {17, Int3{17, 9, 5}}, {1 << 10, Int3{1 << 10, 1 << 9, 1 << 8}}}) {
      VoxelizeOptions options;
      options.resolution = resolution;
      auto source = open(scene, options);
      ASSERT_TRUE(source);
      EXPECT_EQ((*source)->extent(), extent) << leak;
    }
  }
}

TEST(MeshFrame, TransformLeadsBackToTheModel) {
  const std::vector<Corner> corners{{1, 2, 3}, {5, 4, 3}, {1, 2, 11}};
  for (const bool zUp : {false, true}) {
    VoxelizeOptions options;
    options.resolution = 16;
    options.zUp = zUp;
    auto source = open(soupOf(corners), options);
    ASSERT_TRUE(source);
    EXPECT_EQ((*source)->extent(), zUp ? (Int3{8, 16, 4}) : (Int3{8, 4, 16}));
    const auto m = rowsOf((*source)->voxelToModel());
    // With z up, the model's low y is the far end of the voxels' z.
    const std::array<double, 3> corner{0, 0, zUp ? 4.0 : 0.0};
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_DOUBLE_EQ(m[4 * i] * corner[0] + m[4 * i + 1] * corner[1] + m[4 * i + 2] * corner[2] +
                           m[4 * i + 3],
                       corners[0][i]);
    EXPECT_TRUE(voxelsOf(**source).contains(mortonCode({0, 0, zUp ? 3 : 0})));
  }
}

TEST(MeshFrame, ResolutionZeroFillsWhatThereIs) {
  VoxelizeOptions options;
  options.resolution = 0;
  options.maxExtent = {100, 10, 100};
  auto source = open(soupOf({{0, 0, 0}, {4, 3, 0}, {0, 0, 1}}), options);
  ASSERT_TRUE(source);
  EXPECT_EQ((*source)->extent(), (Int3{13, 10, 4}));
}

TEST(MeshFrame, EnormousAndTinyCoordinatesEnd) {
  EXPECT_FALSE(voxelized(soupOf({{-3e38f, 0, 0}, {3e38f, 1, 0}, {0, 3e38f, 3e38f}}), {32}).empty());
  EXPECT_FALSE(voxelized(soupOf({{0, 0, 0}, {1e-45f, 0, 0}, {0, 1e-45f, 0}}), {32}).empty());
  const auto point = soupOf({{2, 2, 2}});
  point->parts[0].mode = PrimitiveMode::Points;
  EXPECT_EQ(voxelized(point, {32}).size(), 1u);
}

TEST(MeshFrame, TheGridIsCoarserForWhatReachesFarAndEndsAtALimit) {
  VoxelizeOptions options;
  options.resolution = 8;
  options.bounds = {{0, 0, 0, 8, 8, 8}};
  // The plane z = 2.5 through all of the volume, from 2^34 voxels away; and twice as far.
  const std::vector<Corner> far{{-0x1p34f, -0x1p34f, 2.5f}, {0x1p34f, -0x1p34f, 2.5f}, {0, 0x1p34f, 2.5f}};
  const Voxels voxels = voxelized(soupOf(far), options);
  EXPECT_EQ(voxels.size(), 64u);
  for (const auto &[code, word] : voxels)
    EXPECT_EQ(mortonCell(code).z, 2);
  const auto farther = open(soupOf({{-0x1p36f, 0, 2.5f}, {0x1p36f, 0, 2.5f}, {0, 0x1p36f, 2.5f}}), options);
  ASSERT_FALSE(farther);
  EXPECT_NE(farther.error().message.find("68719476736"), std::string::npos) << farther.error().message;
}

TEST(MeshFrame, WholeExtentOfVoxelsIsReached) {
  VoxelizeOptions options;
  options.resolution = 1 << 21;
  const auto line = soupOf({{0, 0, 0}, {1, 1, 1}});
  line->parts[0].mode = PrimitiveMode::Lines;
  auto source = open(line, options);
  ASSERT_TRUE(source) << source.error().message;
  const int last = (1 << 21) - 1;
  for (const int at : {0, 1 << 20, last})
    EXPECT_FALSE((*source)->empty({{at, at, at}, 0}));
  EXPECT_TRUE((*source)->empty({{last, 0, 0}, 0}));
}

std::string problem(const std::shared_ptr<TriangleScene> &scene, const VoxelizeOptions &options = {}) {
  const auto source = open(scene, options);
  const auto reference = makeReferenceMeshSource(*scene, options);
  EXPECT_FALSE(reference);
  return source ? "no error" : source.error().message;
}

TEST(MeshFrame, BadScenesAreErrors) {
  EXPECT_EQ(problem(soupOf({})), "the mesh has no triangle");
  EXPECT_NE(problem(soupOf({{0, 0, 0}, {1, 0, 0}, {0, NAN, 0}})).find("finite"), std::string::npos);
  EXPECT_NE(problem(soupOf({{0, 0, 0}, {1, 0, 0}, {0, INFINITY, 0}})).find("finite"), std::string::npos);
  auto scene = soupOf(kUnitTriangle);
  scene->instances[0].toModel[0][0] = 1e308;
  scene->instances[0].toModel[3][0] = 1e308;
  EXPECT_NE(problem(scene).find("finite"), std::string::npos);
  EXPECT_NE(problem(sceneOf({{kUnitTriangle, {0, 1, 3}}})).find("vertex that does not exist"),
            std::string::npos);
  EXPECT_NE(problem(sceneOf({{kUnitTriangle, {}, {{0, 0}}}})).find("not for all"), std::string::npos);
  scene = soupOf(kUnitTriangle);
  scene->parts[0].material = 1;
  EXPECT_NE(problem(scene).find("material that does not exist"), std::string::npos);
  scene = soupOf(kUnitTriangle);
  scene->instances[0].part = 1;
  EXPECT_NE(problem(scene).find("part that does not exist"), std::string::npos);
  scene = soupOf(kUnitTriangle);
  scene->materials[0].alphaMask.texture = 0;
  EXPECT_NE(problem(scene).find("texture that does not exist"), std::string::npos);
  scene->textures.push_back(test::textureOf(2, 2, {1, 2, 3}));
  EXPECT_NE(problem(scene).find("texels"), std::string::npos);
}

TEST(MeshFrame, TooManyTrianglesAreAnError) {
  auto scene = soupOf(kUnitTriangle);
  MeshPart &part = scene->parts[0];
  part.positions.count = std::uint64_t{3} << 32;
  part.positions.stride = 0;
  EXPECT_EQ(problem(scene), "the mesh has 2^32 triangles or more");
}

TEST(MeshFrame, BadBoundsAreErrors) {
  VoxelizeOptions options;
  options.bounds = {{0, 0, 0, -1, 1, 1}};
  EXPECT_NE(problem(soupOf(kUnitTriangle), options).find("bounds"), std::string::npos);
  options.bounds = {{0, 0, 0, NAN, 1, 1}};
  EXPECT_NE(problem(soupOf(kUnitTriangle), options).find("bounds"), std::string::npos);
  options = {};
  options.maxExtent = {256, 512, 512};
  EXPECT_NE(problem(soupOf(kUnitTriangle), options).find("256x512x512"), std::string::npos);
}

TEST(MeshFrame, StopsWhenAsked) {
  std::atomic<bool> stop = true;
  VoxelizeOptions options;
  options.progress.stop = &stop;
  const auto stopped = open(soupOf(kUnitTriangle), options);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::Interrupted);
  stop = false;
  auto source = open(soupOf(kUnitTriangle), options);
  ASSERT_TRUE(source);
  stop = true;
  Voxels voxels;
  const Expected<void> collected = collect(**source, {{}, 7}, voxels);
  ASSERT_FALSE(collected);
  EXPECT_EQ(collected.error().kind, ErrorKind::Interrupted);
}

TEST(MeshFrame, TellsHowFarItIs) {
  std::vector<double> fractions;
  VoxelizeOptions options;
  options.progress.report = [&](std::string_view stage, double fraction, std::uint64_t) {
    EXPECT_EQ(stage, "bin");
    fractions.push_back(fraction);
  };
  voxelized(soupOf(kUnitTriangle), options);
  EXPECT_EQ(fractions, (std::vector<double>{0, 0.5}));
}

} // namespace
} // namespace voxc
