// Meshes of .ply files.
#include "LoadTesting.h"

#include <bit>
#include <cmath>

namespace voxc {
namespace {

class PlyScene : public LoadTest {};

const std::string kVertices = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kColourProperties = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
const std::string kFaces = "element face 1\nproperty list uchar int vertex_index\n";
const std::string kEnd = "end_header\n";
const std::string kAscii = "ply\nformat ascii 1.0\n";

TEST_F(PlyScene, FacesAndColours) {
  const TriangleScene scene =
      load("m.ply", kAscii + kVertices + kColourProperties + kFaces + kEnd +
                        "0 0 0 1 2 3\n1 0 0 4 5 6\n1 1 0 7 8 9\n0 1 0 255 0 51\n4 0 1 2 3\n");
  ASSERT_EQ(countTriangles(scene), 2u);
  const MeshPart &part = scene.parts[0];
  EXPECT_EQ(part.corners(1), (std::array<std::uint32_t, 3>{0, 2, 3}));
  EXPECT_EQ(readRow<4>(part.colours, 3), (std::array<double, 4>{1, 0, 0.2, 1}));
  EXPECT_EQ(materialOf(scene, 0).colour, (std::array<float, 4>{1, 1, 1, 1}));
}

TEST_F(PlyScene, FloatAndDiffuseColours) {
  const std::string head =
      kAscii + "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string rows = "0 0 0 0.2 1 0 1\n1 0 0 0 0 0 1\n0 1 0 0 0 0 1\n3 0 1 2\n";
  for (const std::string prefix : {"", "diffuse_"}) {
    std::string properties;
    for (const char *channel : {"red", "green", "blue", "alpha"})
      properties += "property float " + prefix + channel + "\n";
    const TriangleScene scene = load("m.ply", head + properties + kFaces + kEnd + rows);
    EXPECT_EQ(readRow<4>(scene.parts[0].colours, 0), (std::array<double, 4>{0.2, 1, 0, 1}));
  }
}

template <typename Value> std::string ordered(Value value, bool big) {
  std::string bytes = bytesOf({value});
  if (big == (std::endian::native == std::endian::little))
    std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

TEST_F(PlyScene, BothByteOrders) {
  for (const bool big : {false, true}) {
    std::string rows;
    for (const float coordinate : {0.f, 0.f, 0.f, 1.5f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, -2.f})
      rows += ordered(coordinate, big);
    rows += '\3' + ordered(1, big) + ordered(2, big) + ordered(3, big);
    const TriangleScene scene = load("m.ply", std::string("ply\nformat binary_") + (big ? "big" : "little") +
                                                  "_endian 1.0\n" + kVertices + kFaces + kEnd + rows);
    const auto triangles = trianglesOf(scene);
    ASSERT_EQ(triangles.size(), 1u);
    EXPECT_EQ(triangles[0], (std::array<ReadCorner, 3>{{{1.5, 0, 0}, {1, 1, 0}, {0, 1, -2}}}));
  }
}

TEST_F(PlyScene, DoublesStayDoubles) {
  const TriangleScene scene =
      load("m.ply", kAscii + "element vertex 3\nproperty double x\nproperty float y\n" + "property int z\n" +
                        kFaces + kEnd + "0.1 0 16777217\n+1e0 0 0\n1e-400 1 0\n3 0 1 2\n");
  EXPECT_EQ(trianglesOf(scene)[0], (std::array<ReadCorner, 3>{{{0.1, 0, 16777217}, {1, 0, 0}, {0, 1, 0}}}));
}

TEST_F(PlyScene, StripsWithRestarts) {
  const TriangleScene scene =
      load("m.ply", kAscii + kVertices + "element tristrips 1\nproperty list int int vertex_indices\n" +
                        kEnd + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n10 0 1 2 3 -1 1 2 -1 3 0\n");
  ASSERT_EQ(countTriangles(scene), 2u);
  // Every second triangle of a strip is stored turned around.
  EXPECT_EQ(scene.parts[0].corners(1), (std::array<std::uint32_t, 3>{2, 1, 3}));
}

TEST_F(PlyScene, OtherElementsArePassedOver) {
  const TriangleScene scene = load(
      "m.ply", kAscii + "element camera 2\nproperty list uchar float view\nproperty int id\n" +
                   "comment vertex\nobj_info x\nelement vertex 3\nproperty float nx\nproperty float x\n" +
                   "property float y\nproperty float z\nelement face 1\nproperty uchar flags\n" +
                   "property list uchar uint vertex_indices\nproperty list uchar float texcoord\n" + kEnd +
                   "2 1 2 3\n0 4\n9 0 0 0\n9 1 0 0\n9 0 1 0\n7 3 0 1 2 6 0 0 1 0 0 1\n");
  EXPECT_EQ(trianglesOf(scene)[0], (std::array<ReadCorner, 3>{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}));
}

TEST_F(PlyScene, FacesBeforeVertices) {
  const TriangleScene scene =
      load("m.ply", kAscii + kFaces + kVertices + kEnd + "4 0 1 2 3\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n");
  EXPECT_EQ(countTriangles(scene), 2u);
  // Of a corner that goes inwards no fan may cover what is outside.
  const TriangleScene arrow =
      load("m.ply", kAscii + kFaces + kVertices + kEnd + "4 0 1 2 3\n0 0 0\n4 0 0\n1 1 0\n0 4 0\n");
  ASSERT_EQ(countTriangles(arrow), 2u);
  double area = 0;
  for (const auto &[a, b, c] : trianglesOf(arrow))
    area += std::abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
  EXPECT_EQ(area, 4);
}

TEST_F(PlyScene, FreeTextInTheHeader) {
  const std::string rest = kVertices + kFaces + kEnd + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
  const std::string made = "Created by Blender3D 2.47 - www.blender.org, source file: a.blend\n";
  const TriangleScene scene = load("m.ply", kAscii + made + rest);
  EXPECT_EQ(countTriangles(scene), 2u);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(
      scene.warnings[0].find("'Created by Blender3D 2.47 - www.blender.org, source file: a.blend', which "
                             "is taken for a comment"),
      std::string::npos);
  // What could be meant as a statement is none.
  for (const std::string line :
       {"Element vertex 4\n", "elements vertex 4\n", "elephant\n", "property float q\n"})
    EXPECT_NE(
        problem("m.ply", kAscii + line + rest).find("which is not a format, element, property or comment"),
        std::string::npos);
  EXPECT_NE(problem("m.ply", kAscii + kVertices + made + kFaces + kEnd).find("which is not a format"),
            std::string::npos);
  std::string wide;
  for (const char c : kAscii + rest)
    wide += std::string(1, c) + '\0';
  EXPECT_NE(problem("m.ply", wide).find("it is UTF-16 text"), std::string::npos);
}

} // namespace
} // namespace voxc
