// Binary and text .stl.
#include "LoadTesting.h"

namespace voxc {
namespace {

class StlReader : public LoadTest {};

const std::array<Corner, 3> kCorners{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}};

const std::string kFacet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 2 0\n"
                           "endloop\nendfacet\n";

std::string binary(const std::string &title, std::uint32_t count) {
  std::string file = title + std::string(80 - title.size(), '\0') + bytesOf({count});
  for (std::uint32_t i = 0; i < count; ++i)
    file += bytesOf({0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 2.f, 0.f}) + "\x1f\x80";
  return file;
}

TEST_F(StlReader, ReadsText) {
  const TriangleScene scene =
      load("m.stl", "solid a b\n" + kFacet + kFacet + "endsolid a b\nsolid\n" + kFacet);
  const auto triangles = trianglesOf(scene);
  ASSERT_EQ(triangles.size(), 3u);
  EXPECT_EQ(triangles[2], kCorners);
}

TEST_F(StlReader, TextNeedsNoLines) {
  const TriangleScene scene =
      load("m.stl", " SOLID s\nFACET NORMAL 0 0 1 OUTER LOOP VERTEX 0 0 0 VERTEX +1 0 0 "
                    "VERTEX 0 2e0 0 ENDLOOP ENDFACET\r\nENDSOLID s");
  EXPECT_EQ(trianglesOf(scene)[0], kCorners);
}

TEST_F(StlReader, LoopsOfFour) {
  const TriangleScene scene =
      load("m.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                    "vertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n");
  EXPECT_EQ(countTriangles(scene), 2u);
}

TEST_F(StlReader, ReadsBinary) {
  const TriangleScene scene = load("m.stl", binary("some program", 2));
  const auto triangles = trianglesOf(scene);
  ASSERT_EQ(triangles.size(), 2u);
  EXPECT_EQ(triangles[1], kCorners);
  EXPECT_FALSE(scene.parts[0].colours);
}

TEST_F(StlReader, BinaryMayBeginAsText) {
  EXPECT_EQ(countTriangles(load("m.stl", binary("solid of some program", 3))), 3u);
  EXPECT_EQ(countTriangles(load("m.stl", binary("solid", 1) + "and more behind")), 1u);
}

} // namespace
} // namespace voxc
