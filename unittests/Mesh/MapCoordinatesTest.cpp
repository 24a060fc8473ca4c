// Models that lie where maps have them: coordinates of seven digits before the point and four behind it are
// kept.
#include "LoadTesting.h"

#include "voxc/Mesh/MeshSource.h"

#include <cstdio>
#include <random>

namespace voxc {
namespace {

/// UTM's easting, a height and its northing, which float32 has in steps of 1/32, 2^-16 and 1/2.
constexpr ReadCorner kUtm{500123.25, 200.25, 5412345.5};
constexpr std::size_t kTriangles = 60;

/// Corners in steps of 2^-12, which move without any rounding of doubles.
std::vector<ReadCorner> corners() {
  std::mt19937 random(3);
  std::vector<ReadCorner> result(3 * kTriangles);
  for (ReadCorner &corner : result)
    for (double &coordinate : corner)
      coordinate = static_cast<double>(random() % 40961) / 4096;
  return result;
}

std::string lineOf(const char *word, const ReadCorner &corner, const ReadCorner &origin) {
  char line[160];
  std::snprintf(line, sizeof line, "%s%.12f %.12f %.12f\n", word, corner[0] + origin[0],
                corner[1] + origin[1], corner[2] + origin[2]);
  return line;
}

std::string objAt(const ReadCorner &origin) {
  std::string text;
  for (const ReadCorner &corner : corners())
    text += lineOf("v ", corner, origin);
  for (std::size_t i = 1; i < 3 * kTriangles; i += 3)
    text += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + "\n";
  return text;
}

std::string stlAt(const ReadCorner &origin) {
  std::string text = "solid s\n";
  std::size_t number = 0;
  for (const ReadCorner &corner : corners()) {
    if (number % 3 == 0)
      text += "facet normal 0 0 0\nouter loop\n";
    text += lineOf("vertex ", corner, origin);
    if (++number % 3 == 0)
      text += "endloop\nendfacet\n";
  }
  return text + "endsolid s\n";
}

/// What programs call float here has as many digits as what they call double.
std::string plyAt(const ReadCorner &origin) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(3 * kTriangles) +
                     "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                     std::to_string(kTriangles) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const ReadCorner &corner : corners())
    text += lineOf("", corner, origin);
  for (std::size_t i = 0; i < 3 * kTriangles; i += 3)
    text += "3 " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + "\n";
  return text;
}

class MapCoordinates : public LoadTest {
protected:
  Voxels voxels(const std::string &name, const std::string &content) {
    const auto scene = std::make_shared<const TriangleScene>(load(name, content));
    VoxelizeOptions options;
    options.resolution = 96;
    auto source = makeMeshSource(scene, options, memory_);
    EXPECT_TRUE(source) << source.error().message;
    return source ? voxelsOf(**source) : Voxels{};
  }
};

TEST_F(MapCoordinates, AreKeptFromTextToVoxels) {
  const Voxels near = voxels("near.obj", objAt({}));
  EXPECT_GT(near.size(), 5000u);
  EXPECT_EQ(voxels("far.obj", objAt(kUtm)), near);
  EXPECT_EQ(voxels("near.stl", stlAt({})), near);
  EXPECT_EQ(voxels("far.stl", stlAt(kUtm)), near);
  EXPECT_EQ(voxels("near.ply", plyAt({})), near);
  EXPECT_EQ(voxels("far.ply", plyAt(kUtm)), near);
}

TEST_F(MapCoordinates, OfPlanetsAndOfAtomsAreKept) {
  const std::string triangle = "v 1e300 0 0\nv 1e300 1e285 0\nv 1e300 0 1e285\nf 1 2 3\n";
  EXPECT_EQ(trianglesOf(load("planet.obj", triangle))[0][1], (ReadCorner{1e300, 1e285, 0}));
  EXPECT_FALSE(voxels("planet.obj", triangle).empty());
  EXPECT_FALSE(voxels("atom.obj", "v 1e-60 0 0\nv 2e-60 0 0\nv 0 1e-60 0\nf 1 2 3\n").empty());
}

} // namespace
} // namespace voxc
