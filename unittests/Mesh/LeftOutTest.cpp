// What .obj, .mtl, .ply and .stl files have that no voxel shows: each is one warning. And lines that end by
// carriage returns alone.
#include "LoadTesting.h"

#include <gmock/gmock.h>

#include <bit>

namespace voxc {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class LeftOut : public LoadTest {};

const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::string withReturns(std::string text) {
  std::ranges::replace(text, '\n', '\r');
  return text;
}

TEST_F(LeftOut, VerticesWithoutAFaceOfObj) {
  EXPECT_THAT(load("m.obj", kCorners + "v 7 7 7\nf 1 2 3\n").warnings,
              ElementsAre("1 vertex is left out, which no face, line or point has"));
  EXPECT_THAT(load("m.obj", kCorners + "v 7 7 7\nv 8 8 8\nv 9 9 9\nl 1 2\nf 1 2 3\np 5\n").warnings,
              ElementsAre(HasSubstr("2 vertices are left out")));
  EXPECT_THAT(load("m.obj", kCorners + "f 1 2 3\n").warnings, IsEmpty());
  EXPECT_THAT(load("m.obj", kCorners).warnings, IsEmpty());
}

TEST_F(LeftOut, VerticesWithoutAFaceOfPly) {
  const auto ply = [&](const std::string &faces) {
    return load("m.ply", "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
                         "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
                         "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n9 9 9\n" +
                             faces)
        .warnings;
  };
  EXPECT_THAT(ply("3 0 1 2\n3 1 3 2\n"), ElementsAre(HasSubstr("1 vertex is left out")));
  EXPECT_THAT(ply("3 0 1 2\n3 0 2 1\n"), ElementsAre(HasSubstr("2 vertices are left out")));
  EXPECT_THAT(ply("3 0 1 2\n3 1 3 4\n"), IsEmpty());
}

TEST_F(LeftOut, NumbersOfVerticesBesideColoursAndWeights) {
  const auto warningsOf = [&](const std::string &more) {
    return load("m.obj", "v 0 0 0" + more + "\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").warnings;
  };
  EXPECT_THAT(warningsOf(" 1"), IsEmpty());
  EXPECT_THAT(warningsOf(" 0.5 0.5 0.5"), IsEmpty());
  for (const char *more : {" 0.5", " 1 2", " 1 0.5 0.5 0.5 9"})
    EXPECT_THAT(warningsOf(more), ElementsAre(HasSubstr("beside x, y, z and a colour, which are not used")))
        << more;
}

TEST_F(LeftOut, FacesWithoutCoordinatesHaveNoTexture) {
  folder_.file("t.tga", kImage);
  folder_.file("m.mtl", "newmtl a\nKd 1 1 0\nmap_Kd t.tga\n");
  const TriangleScene scene = load("m.obj", "mtllib m.mtl\nusemtl a\n" + kCorners +
                                                "vt 0 0\nvt 1 0\nf 1/1 2/2 3/1\nf 3 2 1\nf 1/1 3 2\n");
  ASSERT_EQ(scene.parts.size(), 2u);
  EXPECT_TRUE(scene.parts[0].uvs);
  EXPECT_FALSE(scene.parts[1].uvs);
  EXPECT_EQ(scene.parts[1].triangles(), 2u);
  EXPECT_THAT(scene.warnings, ElementsAre("2 triangles of materials with textures have no texture "
                                          "coordinates, and no texture"));
}

TEST_F(LeftOut, MaterialsThatAreDefinedTwice) {
  folder_.file("m.mtl", "newmtl a\nKd 1 0 0\nnewmtl b\nKd 1 1 1\nkd 0 0 0\nnewmtl a\nKd 0 1 0\n");
  folder_.file("n.mtl", "newmtl b\nKd 0 0 1\n");
  const std::string face = kCorners + "usemtl a\nf 1 2 3\n";
  const TriangleScene scene = load("m.obj", "mtllib m.mtl\n" + face);
  EXPECT_EQ(materialOf(scene, 0).colour, (std::array<float, 4>{0, 1, 0, 1}));
  EXPECT_THAT(scene.warnings,
              ElementsAre("the material library 'm.mtl' says again what was said before; the last "
                          "holds of 'a', kd of 'b'"));
  // Of libraries the first holds, as they are searched one after the other.
  folder_.file("n.mtl", "newmtl a\nKd 0 0 1\nnewmtl c\nKd 0 0 1\n");
  const TriangleScene both = load("m.obj", "mtllib m.mtl n.mtl\n" + face + "usemtl c\nf 1 2 3\n");
  EXPECT_EQ(materialOf(both, 0).colour, (std::array<float, 4>{0, 1, 0, 1}));
  EXPECT_EQ(materialOf(both, 1).colour, (std::array<float, 4>{0, 0, 1, 1}));
  EXPECT_THAT(
      both.warnings,
      ElementsAre(HasSubstr("'m.mtl' says again"),
                  "the material library 'n.mtl' has materials of a library before it, which hold: 'a'"));
  // One that comes late has what was missing before.
  const TriangleScene late = load("late.obj", face + "mtllib n.mtl\nusemtl a\nf 1 2 3\n");
  ASSERT_EQ(late.parts.size(), 2u);
  EXPECT_EQ(materialOf(late, 1).colour, (std::array<float, 4>{0, 0, 1, 1}));
}

TEST_F(LeftOut, OptionsBehindTheNameOfATexture) {
  folder_.file("t.tga", kImage);
  folder_.file("m.mtl", "newmtl a\nmap_Kd t.tga -s 2 2 1\n");
  const std::string model = "mtllib m.mtl\n" + kCorners + "vt 0 0\nusemtl a\nf 1/1 2/1 3/1\n";
  EXPECT_THAT(load("m.obj", model).warnings,
              ElementsAre("the texture 't.tga -s 2 2 1' has options behind its name, which are not used"));
  folder_.file("t -s.tga", kImage);
  folder_.file("m.mtl", "newmtl a\nmap_Kd t -s.tga\n");
  EXPECT_THAT(load("m.obj", model).warnings, IsEmpty());
}

TEST_F(LeftOut, LinesOfObjThatEndByCarriageReturns) {
  folder_.file("m.mtl", withReturns("newmtl a\nKd 0 1 0\n"));
  const std::string model = "mtllib m.mtl\n# v 9\n" + kCorners + "usemtl a\nf 1 2 \\\n3\n";
  for (const bool hasFeeds : {false, true}) {
    const TriangleScene scene =
        load("m.obj", withReturns(model) + (hasFeeds ? "\nv 1 1 1\r\nf 2 3 4\n" : ""));
    EXPECT_EQ(countTriangles(scene), hasFeeds ? 2u : 1u);
    EXPECT_EQ(materialOf(scene, 0).colour, (std::array<float, 4>{0, 1, 0, 1}));
    EXPECT_THAT(scene.warnings, IsEmpty());
  }
  EXPECT_THAT(problem("m.obj", withReturns(model + "f 1 2 9\n")), HasSubstr("line 9: it names the vertex 9"));
}

TEST_F(LeftOut, LinesOfPlyThatEndByCarriageReturns) {
  const std::string head = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                           "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const TriangleScene text =
      load("m.ply", withReturns("ply\nformat ascii 1.0\n" + head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
  EXPECT_EQ(countTriangles(text), 1u);
  // The first byte of the data is a line feed.
  const std::string rows = bytesOf<std::uint32_t>({0x3f80000a, 0, 0, 0, 0, 0, 0, 0x40000000, 0}) + '\3' +
                           bytesOf<std::int32_t>({0, 1, 2});
  const TriangleScene binary =
      load("m.ply", withReturns("ply\nformat binary_little_endian 1.0\n" + head) + rows);
  EXPECT_EQ(trianglesOf(binary)[0][2], (ReadCorner{0, 2, 0}));
  // Blanks behind a line mean nothing.
  EXPECT_EQ(countTriangles(
                load("m.ply", "ply \r\nformat ascii 1.0 \r\n" + head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")),
            1u);
}

TEST_F(LeftOut, NamesOfPlyElementsInAnyCase) {
  const TriangleScene scene =
      load("m.ply", "ply\nformat ascii 1.0\nelement Vertex 3\nproperty float X\nproperty float Y\n"
                    "property float Z\nelement FACE 1\nproperty list uchar int Vertex_Indices\nend_header\n"
                    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(countTriangles(scene), 1u);
}

TEST_F(LeftOut, LinesOfStlThatEndByCarriageReturns) {
  const std::string facet = "solid a b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                            "vertex 0 1 0\nendloop\nendfacet\nendsolid a b\n";
  EXPECT_EQ(countTriangles(load("m.stl", withReturns(facet + facet))), 2u);
  EXPECT_THAT(problem("m.stl", withReturns(facet + "rubbish\n")), HasSubstr("line 10: 'rubbish'"));
}

TEST_F(LeftOut, CommentsOfStlAreNamed) {
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                            "endloop\nendfacet\n";
  EXPECT_THAT(problem("m.stl", "solid a\n" + facet + "; by hand\nendsolid a\n"),
              HasSubstr("line 9: ';' begins a comment, which STL does not have; take comments out"));
  EXPECT_THAT(problem("m.stl", "; by hand\nsolid a\n" + facet + "endsolid a\n"),
              HasSubstr("it begins with a comment, which STL does not have; take out the lines that begin "
                        "with ';'"));
}

TEST_F(LeftOut, NumbersOfStlThatAreBigEndianAreNamed) {
  const std::vector<float> rows{0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  const auto stl = [&](bool isBig) {
    std::string bytes(80, ' ');
    const auto put = [&](std::uint32_t word) {
      for (int i = 0; i < 4; ++i)
        bytes += static_cast<char>(word >> (isBig ? 24 - 8 * i : 8 * i));
    };
    put(1);
    for (const float number : rows)
      put(std::bit_cast<std::uint32_t>(number));
    return bytes + std::string(2, '\0');
  };
  EXPECT_EQ(countTriangles(load("m.stl", stl(false))), 1u);
  EXPECT_THAT(problem("m.stl", stl(true)), HasSubstr("its numbers are big-endian"));
}

} // namespace
} // namespace voxc
