// Voxelization against exact arithmetic, and the frame of voxels around a mesh.
#include "ExactTriangle.h"
#include "Source/SourceTesting.h"
#include "TestLength.h"

#include "voxc/Mesh/Voxelizer.h"

#include <random>

namespace voxc {
namespace {

TriangleMesh meshOf(const std::vector<Float3> &corners) {
  TriangleMesh mesh;
  mesh.positions = corners;
  for (std::uint32_t i = 0; i + 2 < corners.size(); i += 3)
    mesh.triangles.push_back({{i, i + 1, i + 2}, 0});
  mesh.materials.emplace_back();
  return mesh;
}

Voxels voxelized(const TriangleMesh &mesh, const VoxelizeOptions &options) {
  auto source = voxelize(mesh, options);
  EXPECT_TRUE(source) << source.error().message;
  return source ? voxelsOf(**source) : Voxels{};
}

/// The triangle in voxels, without rounding.
ExactTriangle toVoxels(const TriangleMesh &mesh, const std::array<double, 6> &bounds, int resolution) {
  const Rational longest =
      std::max({Rational(bounds[3]) - Rational(bounds[0]), Rational(bounds[4]) - Rational(bounds[1]),
                Rational(bounds[5]) - Rational(bounds[2])});
  ExactTriangle triangle;
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (std::size_t axis = 0; axis < 3; ++axis)
      triangle[corner][axis] =
          (Rational(mesh.positions[corner][axis]) - Rational(bounds[axis])) * resolution / longest;
  return triangle;
}

/// No touched voxel is missing, and none is there that is farther away than `margin`.
void expectConservative(const TriangleMesh &mesh, const std::array<double, 6> &bounds, int resolution,
                        double margin) {
  VoxelizeOptions options;
  options.resolution = resolution;
  options.bounds = bounds;
  auto source = voxelize(mesh, options);
  ASSERT_TRUE(source) << source.error().message;
  const Voxels voxels = voxelsOf(**source);
  const ExactTriangle triangle = toVoxels(mesh, bounds, resolution);
  const Int3 extent = (*source)->extent();
  for (Int3 voxel; voxel.z < extent.z; ++voxel.z)
    for (voxel.y = 0; voxel.y < extent.y; ++voxel.y)
      for (voxel.x = 0; voxel.x < extent.x; ++voxel.x) {
        const bool isThere = voxels.contains(mortonCode(voxel));
        ASSERT_EQ(isThere, touchesExactly(triangle, voxel, isThere ? margin : 0))
            << voxel.x << " " << voxel.y << " " << voxel.z;
      }
}

TEST(Voxelizer, TouchesExactlyWhatATriangleOnALatticeTouches) {
  std::mt19937 random(1);
  // Eighths from -2 to 10: corners, edges and faces of voxels are met often, and doubles are exact.
  const auto coordinate = [&] { return static_cast<float>(random() % 97) / 8 - 2; };
  const auto point = [&] { return Float3{coordinate(), coordinate(), coordinate()}; };
  for (int i = 0; i < test::rounds(30); ++i)
    expectConservative(meshOf({point(), point(), point()}), {0, 0, 0, 8, 8, 8}, 8, 0);
}

TEST(Voxelizer, MissesNothingUnderRounding) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> coordinate(-0.3f, 1.3f);
  const auto point = [&] { return Float3{coordinate(random), coordinate(random), coordinate(random)}; };
  for (int i = 0; i < test::rounds(20); ++i)
    expectConservative(meshOf({point(), point(), point()}), {0.1, 0.05, 0, 1, 0.7, 0.9}, 7, 0x1p-30);
}

TEST(Voxelizer, MissesNoTouchThatRoundingWouldLose) {
  std::mt19937 random(3);
  // Steps of 49/16 are eighths of a voxel at a scale of 2/49, which is no double, and 49 times it is not 2.
  const auto coordinate = [&] { return static_cast<float>(random() % 97) * 49 / 16 - 49; };
  const auto point = [&] { return Float3{coordinate(), coordinate(), coordinate()}; };
  for (int i = 0; i < test::rounds(30); ++i)
    expectConservative(meshOf({point(), point(), point()}), {0, 0, 0, 196, 196, 196}, 8, 0x1p-30);
}

TEST(Voxelizer, TrianglesWithoutAreaLeaveTheirPointsAndSegments) {
  expectConservative(meshOf({{1.5f, 2, 2.5f}, {1.5f, 2, 2.5f}, {1.5f, 2, 2.5f}}), {0, 0, 0, 4, 4, 4}, 4, 0);
  expectConservative(meshOf({{0.25f, 0, 0}, {3, 3.5f, 1}, {0.25f, 0, 0}}), {0, 0, 0, 4, 4, 4}, 4, 0);
}

TEST(Voxelizer, FarFaceIsKeptInTheLastVoxels) {
  // A box of 4 x 2 x 1: its faces lie on the faces of the extent.
  std::vector<Float3> corners;
  for (const float x : {-1.0f, 3.0f})
    for (const Float3 &p : {Float3{x, 0, 0}, Float3{x, 2, 0}, Float3{x, 2, 1}})
      corners.push_back(p);
  VoxelizeOptions options;
  options.resolution = 12;
  auto source = voxelize(meshOf(corners), options);
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

TEST(Voxelizer, TransformLeadsBackToTheModel) {
  const TriangleMesh mesh = meshOf({{1, 2, 3}, {5, 4, 3}, {1, 2, 11}});
  for (const bool zUp : {false, true}) {
    VoxelizeOptions options;
    options.resolution = 16;
    options.zUp = zUp;
    auto source = voxelize(mesh, options);
    ASSERT_TRUE(source);
    EXPECT_EQ((*source)->extent(), zUp ? (Int3{8, 16, 4}) : (Int3{8, 4, 16}));
    const auto &m = (*source)->voxelToModel().rows;
    // With z up, the model's low y is the far end of the voxels' z.
    const std::array<double, 3> corner{0, 0, zUp ? 4.0 : 0.0};
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_DOUBLE_EQ(m[4 * i] * corner[0] + m[4 * i + 1] * corner[1] + m[4 * i + 2] * corner[2] +
                           m[4 * i + 3],
                       mesh.positions[0][i]);
    EXPECT_TRUE(voxelsOf(**source).contains(mortonCode({0, 0, zUp ? 3 : 0})));
  }
}

TEST(Voxelizer, ResolutionZeroFillsWhatThereIs) {
  VoxelizeOptions options;
  options.resolution = 0;
  options.maxExtent = {100, 10, 100};
  auto source = voxelize(meshOf({{0, 0, 0}, {4, 3, 0}, {0, 0, 1}}), options);
  ASSERT_TRUE(source);
  EXPECT_EQ((*source)->extent(), (Int3{13, 10, 4}));
}

TEST(Voxelizer, BadMeshesAreErrors) {
  const auto problem = [](const TriangleMesh &mesh, const VoxelizeOptions &options = {}) {
    auto source = voxelize(mesh, options);
    return source ? "no error" : source.error().message;
  };
  const std::vector<Float3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(problem(meshOf({})), "the mesh has no triangle");
  EXPECT_NE(problem(meshOf({{0, 0, 0}, {1, 0, 0}, {0, NAN, 0}})).find("finite"), std::string::npos);
  EXPECT_NE(problem(meshOf({{0, 0, 0}, {1, 0, 0}, {0, INFINITY, 0}})).find("finite"), std::string::npos);
  TriangleMesh mesh = meshOf(corners);
  mesh.triangles[0].vertices[1] = 3;
  EXPECT_NE(problem(mesh).find("does not exist"), std::string::npos);
  mesh = meshOf(corners);
  mesh.triangles[0].material = 1;
  EXPECT_NE(problem(mesh).find("does not exist"), std::string::npos);
  mesh = meshOf(corners);
  mesh.materials[0].texture = 0;
  EXPECT_NE(problem(mesh).find("texture"), std::string::npos);
  VoxelizeOptions options;
  options.bounds = {{0, 0, 0, -1, 1, 1}};
  EXPECT_NE(problem(meshOf(corners), options).find("bounds"), std::string::npos);
  options.bounds = {{0, 0, 0, NAN, 1, 1}};
  EXPECT_NE(problem(meshOf(corners), options).find("bounds"), std::string::npos);
  options = {};
  options.maxExtent = {256, 512, 512};
  EXPECT_NE(problem(meshOf(corners), options).find("256x512x512"), std::string::npos);
}

TEST(Voxelizer, EnormousAndTinyCoordinatesEnd) {
  EXPECT_FALSE(voxelized(meshOf({{-3e38f, 0, 0}, {3e38f, 1, 0}, {0, 3e38f, 3e38f}}), {32}).empty());
  EXPECT_FALSE(voxelized(meshOf({{0, 0, 0}, {1e-45f, 0, 0}, {0, 1e-45f, 0}}), {32}).empty());
  EXPECT_EQ(voxelized(meshOf({{2, 2, 2}, {2, 2, 2}, {2, 2, 2}}), {32}).size(), 1u);
}

TEST(Voxelizer, StopsWhenAsked) {
  const std::atomic<bool> stop = true;
  VoxelizeOptions options;
  options.progress.stop = &stop;
  auto source = voxelize(meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), options);
  ASSERT_FALSE(source);
  EXPECT_EQ(source.error().kind, ErrorKind::Interrupted);
}

} // namespace
} // namespace voxc
