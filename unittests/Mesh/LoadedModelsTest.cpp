// Real models: what their authors counted is what comes out.
#include "LoadTesting.h"
#include "SharedModels.h"

namespace voxc {
namespace {

class LoadedModels : public testing::Test {
protected:
  /// Skips the test if the model is not there.
  void load(const std::string &name, TriangleScene &scene) {
    const std::string path = unpackedModel(name, folder_.path(""));
    if (path.empty())
      GTEST_SKIP() << "the shared model " << name << " is not there";
    auto loaded = loadScene(path, WorkingMemory::createDefault());
    ASSERT_TRUE(loaded) << loaded.error().message;
    scene = std::move(*loaded);
  }

  TemporaryFolder folder_;
};

/// Ends the test if the model is not there or not loaded.
#define VOXC_LOAD(name, scene)                                                                               \
  TriangleScene scene;                                                                                       \
  load(name, scene);                                                                                         \
  if (scene.parts.empty())                                                                                   \
  return

using Box = std::array<ReadCorner, 2>;

Box boxOf(const TriangleScene &scene) {
  Box box{ReadCorner{1e300, 1e300, 1e300}, ReadCorner{-1e300, -1e300, -1e300}};
  for (const auto &triangle : trianglesOf(scene))
    for (const ReadCorner &corner : triangle)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box[0][axis] = std::min(box[0][axis], corner[axis]);
        box[1][axis] = std::max(box[1][axis], corner[axis]);
      }
  return box;
}

void expectBox(const TriangleScene &scene, const Box &expected, double tolerance) {
  const Box box = boxOf(scene);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(box[0][axis], expected[0][axis], tolerance);
    EXPECT_NEAR(box[1][axis], expected[1][axis], tolerance);
  }
}

TEST_F(LoadedModels, SanMiguel) {
  VOXC_LOAD("san_miguel.glb", scene);
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(countTriangles(scene), 9430202u);
  EXPECT_EQ(scene.materials.size(), 291u);
  EXPECT_EQ(scene.textures.size(), 221u);
  expectBox(scene, {{{-38, -0.46, -37}, {46.8, 53.5, 36.9}}}, 0.1);
}

TEST_F(LoadedModels, Sponza) {
  VOXC_LOAD("sponza/sponza.obj", scene);
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(countTriangles(scene), 279163u);
  EXPECT_EQ(scene.textures.size(), 27u);
  expectBox(scene, {{{-1921, -126, -1183}, {1800, 1429, 1105}}}, 1);
}

TEST_F(LoadedModels, EngineOfDeepNodes) {
  VOXC_LOAD("2CylinderEngine.glb", scene);
  EXPECT_EQ(countTriangles(scene), 121496u);
  expectBox(scene, {{{-371.692, -180.972, -140}, {371.692, 92.0416, 128}}}, 0.01);
}

TEST_F(LoadedModels, Ply) {
  const std::array<std::pair<const char *, std::uint64_t>, 4> models{
      {{"buddha_100k.ply", 100000},
       {"bunny.ply", 69451},
       {"armadillo.ply", 86482},
       {"hairball_standin_small.ply", 144600}}};
  for (const auto &[name, triangles] : models) {
    VOXC_LOAD(name, scene);
    EXPECT_EQ(countTriangles(scene), triangles) << name;
  }
}

TEST_F(LoadedModels, SpotIsTheSameAsGlbAndPly) {
  VOXC_LOAD("spot_vertex_colors.glb", glb);
  VOXC_LOAD("spot_vertex_colors.ply", ply);
  EXPECT_EQ(countTriangles(ply), 5856u);
  EXPECT_EQ(trianglesOf(glb), trianglesOf(ply));
  const MeshPart &a = glb.parts[0];
  const MeshPart &b = ply.parts[0];
  for (std::uint64_t i = 0; i < a.triangles(); ++i)
    for (std::size_t corner = 0; corner < 3; ++corner)
      EXPECT_EQ(readRow<4>(a.colours, a.corners(i)[corner]), readRow<4>(b.colours, b.corners(i)[corner]));
}

TEST_F(LoadedModels, SpotAsObjIsWhereItsPlyIs) {
  VOXC_LOAD("spot/spot.obj", obj);
  EXPECT_TRUE(obj.warnings.empty());
  EXPECT_EQ(countTriangles(obj), 5856u);
  ASSERT_EQ(obj.textures.size(), 1u);
  expectBox(obj, {{{-0.472, -0.737, -0.669}, {0.472, 0.954, 1.05}}}, 0.01);
}

TEST_F(LoadedModels, CubeOfVertexColours) {
  VOXC_LOAD("cube_with_vertexcolors.obj", scene);
  const MeshPart &part = scene.parts[0];
  bool found = false;
  for (std::uint64_t i = 0; i < part.positions.count; ++i) {
    if (readRow<3>(part.positions, i) != std::array<double, 3>{0, 0, 0})
      continue;
    found = true;
    EXPECT_EQ(readRow<4>(part.colours, i), (std::array<double, 4>{124 / 255.0, 110 / 255.0, 120 / 255.0, 1}));
  }
  EXPECT_TRUE(found);
}

} // namespace
} // namespace voxc
