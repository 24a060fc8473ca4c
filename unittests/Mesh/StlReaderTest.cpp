// Binary and text .stl.
#include "LoadTesting.h"

namespace voxc {
namespace {

class StlReader : public LoadTest {};

const std::array<ReadCorner, 3> kFacetCorners{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}};

const std::string kFacet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 2 0\n"
                           "endloop\nendfacet\n";

/// A triangle for each pair of bytes behind it.
std::string coloured(const std::string &title, const std::vector<std::uint16_t> &colours) {
  std::string file =
      title + std::string(80 - title.size(), '\0') + bytesOf({static_cast<std::uint32_t>(colours.size())});
  for (const std::uint16_t colour : colours)
    file += bytesOf({0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 2.f, 0.f}) + bytesOf({colour});
  return file;
}

std::string binary(const std::string &title, std::uint32_t count) {
  return coloured(title, std::vector<std::uint16_t>(count));
}

using Rgba = std::array<int, 4>;

/// The one colour of a triangle, in bytes.
Rgba colourOf(const TriangleScene &scene, std::uint64_t triangle) {
  const auto of = [&](std::size_t corner) {
    const auto colour = readRow<4>(scene.parts[0].colours, scene.parts[0].corners(triangle)[corner]);
    return Rgba{static_cast<int>(colour[0] * 255 + 0.5), static_cast<int>(colour[1] * 255 + 0.5),
                static_cast<int>(colour[2] * 255 + 0.5), static_cast<int>(colour[3] * 255 + 0.5)};
  };
  EXPECT_EQ(of(0), of(1));
  EXPECT_EQ(of(0), of(2));
  return of(0);
}

TEST_F(StlReader, ReadsText) {
  const TriangleScene scene =
      load("m.stl", "solid a b\n" + kFacet + kFacet + "endsolid a b\nsolid\n" + kFacet);
  const auto triangles = trianglesOf(scene);
  ASSERT_EQ(triangles.size(), 3u);
  EXPECT_EQ(triangles[2], kFacetCorners);
}

TEST_F(StlReader, LoopsOfTextAreClosed) {
  std::string open = kFacet;
  open.erase(open.find("endloop\n"), 8);
  for (const std::string &file : {"solid\n" + open + kFacet, "solid\n" + kFacet + open,
                                  "solid\n" + kFacet + "vertex 1 2 3\n" + kFacet + "endsolid\n"})
    EXPECT_NE(problem("m.stl", file).find("is not closed by endloop"), std::string::npos) << file;
}

TEST_F(StlReader, TextMayBeginWithAMark) {
  EXPECT_EQ(countTriangles(load("m.stl", "\xef\xbb\xbfsolid a\n" + kFacet)), 1u);
}

TEST_F(StlReader, BytesBehindTheTrianglesAreTold) {
  const TriangleScene scene = load("m.stl", binary("", 2) + "abc");
  EXPECT_EQ(countTriangles(scene), 2u);
  EXPECT_EQ(scene.warnings,
            std::vector<std::string>{
                "3 bytes are left out, which lie behind the 2 triangles that its header says"});
  std::string fewer = binary("", 3);
  fewer[80] = 1;
  EXPECT_EQ(countTriangles(load("m.stl", fewer)), 1u);
  EXPECT_EQ(load("m.stl", fewer).warnings.size(), 1u);
  EXPECT_TRUE(load("m.stl", binary("", 2)).warnings.empty());
}

TEST_F(StlReader, HeadersThatDoNotKnowTheirTriangles) {
  for (const char byte : {'\0', '\xff'}) {
    std::string file = binary("", 2);
    file.replace(80, 4, std::string(4, byte));
    const TriangleScene scene = load("m.stl", file);
    EXPECT_EQ(countTriangles(scene), 2u);
    EXPECT_EQ(scene.warnings, std::vector<std::string>{
                                  "its header does not say how many triangles it has; all are taken, 2"});
    EXPECT_NE(problem("m.stl", file + "a"), "no error");
  }
}

TEST_F(StlReader, TextNeedsNoLines) {
  const TriangleScene scene =
      load("m.stl", " SOLID s\nFACET NORMAL 0 0 1 OUTER LOOP VERTEX 0 0 0 VERTEX +1 0 0 "
                    "VERTEX 0 2e0 0 ENDLOOP ENDFACET\r\nENDSOLID s");
  EXPECT_EQ(trianglesOf(scene)[0], kFacetCorners);
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
  EXPECT_EQ(triangles[1], kFacetCorners);
  EXPECT_FALSE(scene.parts[0].colours);
}

TEST_F(StlReader, BinaryMayBeginAsText) {
  EXPECT_EQ(countTriangles(load("m.stl", binary("solid of some program", 3))), 3u);
  EXPECT_EQ(countTriangles(load("m.stl", binary("solid", 1) + "and more behind")), 1u);
}

TEST_F(StlReader, ColoursOfVisCam) {
  const TriangleScene scene =
      load("m.stl", coloured("header", {0x8000 | 31 << 10, 0x8000 | 31 << 5 | 16, 0x001f, 0x8000}));
  EXPECT_EQ(colourOf(scene, 0), (Rgba{255, 0, 0, 255}));
  EXPECT_EQ(colourOf(scene, 1), (Rgba{0, 255, 132, 255}));
  EXPECT_EQ(colourOf(scene, 2), (Rgba{255, 255, 255, 255}));
  EXPECT_EQ(colourOf(scene, 3), (Rgba{0, 0, 0, 255}));
  EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(StlReader, ColoursOfMagics) {
  const TriangleScene scene =
      load("m.stl", coloured("COLOR=\x10\xc8\x20\x80", {0xffff, 31, 31 << 10, 31 << 5}));
  EXPECT_EQ(colourOf(scene, 0), (Rgba{16, 200, 32, 128}));
  EXPECT_EQ(colourOf(scene, 1), (Rgba{255, 0, 0, 255}));
  EXPECT_EQ(colourOf(scene, 2), (Rgba{0, 0, 255, 255}));
  EXPECT_EQ(colourOf(scene, 3), (Rgba{0, 255, 0, 255}));
  const TriangleScene whole =
      load("m.stl", coloured(std::string("solid COLOR=\x10\xc8\x20\0,MATERIAL=", 26), {0, 0}));
  EXPECT_EQ(colourOf(whole, 1), (Rgba{16, 200, 32, 255}));
  ASSERT_EQ(whole.warnings.size(), 1u);
  EXPECT_NE(whole.warnings[0].find("MATERIAL"), std::string::npos);
  EXPECT_FALSE(load("m.stl", coloured(std::string(72, ' ') + "COLOR=\1", {0})).parts[0].colours);
}

TEST_F(StlReader, BytesThatAreNoColoursAreSaid) {
  const TriangleScene scene = load("m.stl", coloured("header", {0, 7}));
  EXPECT_FALSE(scene.parts[0].colours);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("no colours"), std::string::npos);
}

TEST_F(StlReader, TextOfUtf16IsCalledThat) {
  std::string text = "\xff\xfe";
  for (const char c : "solid x\n" + kFacet + "endsolid\n")
    text += std::string(1, c) + '\0';
  EXPECT_NE(problem("m.stl", text).find("it is UTF-16 text, which is not read; save it as UTF-8"),
            std::string::npos);
  // The title of a binary file may be anything.
  EXPECT_EQ(countTriangles(load("m.stl", binary(std::string("s\0o\0l\0i\0d\0", 10), 2))), 2u);
}

} // namespace
} // namespace voxc
