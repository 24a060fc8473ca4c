// Colours and textures of .ply files: of vertices and of faces, by the names and numbers of many programs.
#include "LoadTesting.h"

#include <bit>

namespace voxc {
namespace {

using Rgba = std::array<int, 4>;

/// Colours in bytes.
Rgba colourOf(const MeshPart &part, std::uint64_t triangle, std::size_t corner) {
  const auto colour = readRow<4>(part.colours, part.corners(triangle)[corner]);
  Rgba bytes;
  for (std::size_t i = 0; i < 4; ++i)
    bytes[i] = static_cast<int>(colour[i] * 255 + 0.5);
  return bytes;
}

class PlyLooks : public LoadTest {
protected:
  /// Vertices of a unit square and the faces; `vertexRows` and `faceRows` begin with what the square has.
  static std::string text(const std::string &comments, const std::string &vertexProperties,
                          const std::array<std::string, 4> &vertexRows, const std::string &faceProperties,
                          const std::vector<std::string> &faceRows) {
    const std::array<std::string, 4> places{"0 0 0 ", "1 0 0 ", "1 1 0 ", "0 1 0 "};
    std::string all = "ply\nformat ascii 1.0\n" + comments +
                      "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n" +
                      vertexProperties + "element face " + std::to_string(faceRows.size()) +
                      "\nproperty list uchar int vertex_indices\n" + faceProperties + "end_header\n";
    for (std::size_t i = 0; i < 4; ++i)
      all += places[i] + vertexRows[i] + "\n";
    for (const std::string &row : faceRows)
      all += row + "\n";
    return all;
  }

  /// A square whose first vertex has this colour, with three or four properties of this type.
  TriangleScene coloured(const std::string &type, const std::vector<std::string> &names,
                         const std::string &first, const std::string &others) {
    std::string properties;
    for (const std::string &name : names)
      properties += "property " + type + " " + name + "\n";
    return load("m.ply", text("", properties, {first, others, others, others}, "", {"4 0 1 2 3"}));
  }
};

TEST_F(PlyLooks, WhatIsWhollyTransparentIsMeantToBeSeen) {
  const std::vector<std::string> names{"red", "green", "blue", "alpha"};
  TriangleScene scene = coloured("uchar", names, "1 2 3 0", "4 5 6 0");
  EXPECT_EQ(colourOf(scene.parts[0], 0, 0), (Rgba{1, 2, 3, 255}));
  EXPECT_EQ(scene.warnings,
            std::vector<std::string>{"all colours are wholly transparent, and are taken for opaque"});
  scene = coloured("uchar", names, "1 2 3 1", "4 5 6 0");
  EXPECT_EQ(colourOf(scene.parts[0], 0, 1), (Rgba{4, 5, 6, 0}));
  EXPECT_TRUE(scene.warnings.empty());
  scene = load("m.ply", text("", "", {},
                             "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                             "property uchar alpha\n",
                             {"3 0 1 2 9 8 7 0", "3 0 2 3 1 2 3 0"}));
  EXPECT_EQ(colourOf(scene.parts[0], 0, 0), (Rgba{9, 8, 7, 255}));
  EXPECT_EQ(scene.warnings.size(), 1u);
}

TEST_F(PlyLooks, WhatIsLeftOutIsTold) {
  const TriangleScene scene =
      load("m.ply", text("", "", {}, "", {"4 0 1 2 3", "2 0 1", "1 0"}) + " \n\nrest");
  EXPECT_EQ(countTriangles(scene), 2u);
  EXPECT_EQ(scene.warnings,
            (std::vector<std::string>{"2 faces are left out, of fewer than three corners",
                                      "4 bytes are left out, which lie behind the last element"}));
}

TEST_F(PlyLooks, NamesOfColours) {
  const std::vector<std::vector<std::string>> names{{"red", "green", "blue"},
                                                    {"r", "g", "b"},
                                                    {"R", "G", "B"},
                                                    {"Red", "Green", "Blue"},
                                                    {"diffuse_red", "diffuse_green", "diffuse_blue"},
                                                    {"color_r", "color_g", "color_b"},
                                                    {"scalar_Red", "scalar_Green", "scalar_Blue"}};
  for (const auto &three : names) {
    const TriangleScene scene = coloured("uchar", three, "200 100 50", "0 0 0");
    EXPECT_EQ(colourOf(scene.parts[0], 0, 0), (Rgba{200, 100, 50, 255})) << three[0];
    EXPECT_TRUE(scene.warnings.empty()) << three[0];
  }
  EXPECT_EQ(colourOf(coloured("uchar", {"r", "g", "b", "a"}, "1 2 3 4", "0 0 0 9").parts[0], 0, 0),
            (Rgba{1, 2, 3, 4}));
  EXPECT_FALSE(coloured("uchar", {"red", "g", "blue"}, "1 2 3", "0 0 0").parts[0].colours);
}

TEST_F(PlyLooks, NumbersOfColours) {
  const std::vector<std::string> names{"red", "green", "blue"};
  const auto first = [&](const char *type, const char *row, const char *others) {
    return colourOf(coloured(type, names, row, others).parts[0], 0, 0);
  };
  EXPECT_EQ(first("float", "1 0.2 0", "0 0 1"), (Rgba{255, 51, 0, 255}));
  EXPECT_EQ(first("float", "200 100 1", "0 0 255"), (Rgba{200, 100, 1, 255}));
  EXPECT_EQ(first("double", "200.4 100 1", "0 0 255"), (Rgba{200, 100, 1, 255}));
  EXPECT_EQ(first("ushort", "65535 257 0", "0 0 0"), (Rgba{255, 1, 0, 255}));
  EXPECT_EQ(first("ushort", "200 100 1", "0 0 255"), (Rgba{200, 100, 1, 255}));
  EXPECT_EQ(first("int", "200 100 1", "0 0 255"), (Rgba{200, 100, 1, 255}));
  EXPECT_EQ(first("int", "1 0 0", "0 0 0"), (Rgba{1, 0, 0, 255}));
  EXPECT_EQ(first("uint", "4294967295 0 16843009", "0 0 0"), (Rgba{255, 0, 1, 255}));
  EXPECT_EQ(first("char", "-1 127 -128", "0 0 0"), (Rgba{255, 127, 128, 255}));
  EXPECT_TRUE(has(coloured("float", names, "200 100 1", "0 0 255").warnings, "numbers that count to 255"));
  EXPECT_TRUE(coloured("float", names, "1 0.5 0", "0 0 0").warnings.empty());
  EXPECT_TRUE(has(coloured("float", names, "1.5 0.5 0", "0 0 0").warnings, "above 1, and are cut"));
}

TEST_F(PlyLooks, WordsOfColours) {
  const std::string word = std::to_string(0x80c86432u);
  EXPECT_EQ(colourOf(coloured("uint", {"rgba"}, word, "0").parts[0], 0, 0), (Rgba{200, 100, 50, 128}));
  EXPECT_EQ(colourOf(coloured("uint", {"rgb"}, word, "0").parts[0], 0, 0), (Rgba{200, 100, 50, 255}));
  const std::string bits = std::to_string(std::bit_cast<std::int32_t>(0x80c86432u));
  EXPECT_EQ(colourOf(coloured("int", {"rgba"}, bits, "0").parts[0], 0, 0), (Rgba{200, 100, 50, 128}));
}

TEST_F(PlyLooks, ColoursOfFaces) {
  const std::string three = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  for (const char *x : {"float", "double"}) {
    std::string content = text("", "", {}, three, {"3 0 1 2 255 0 0", "3 0 2 3 0 0 255"});
    content.replace(content.find("float x"), 5, x);
    const TriangleScene scene = load("m.ply", content);
    ASSERT_EQ(scene.parts.size(), 1u);
    EXPECT_EQ(colourOf(scene.parts[0], 0, 2), (Rgba{255, 0, 0, 255}));
    EXPECT_EQ(colourOf(scene.parts[0], 1, 0), (Rgba{0, 0, 255, 255}));
    EXPECT_EQ(trianglesOf(scene)[1], (std::array<ReadCorner, 3>{{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}}));
    EXPECT_TRUE(scene.warnings.empty());
  }
  const TriangleScene quad =
      load("m.ply", text("", "", {}, "property float r\nproperty float g\nproperty float b\n",
                         {"4 0 1 2 3 0 255 51"}));
  EXPECT_EQ(countTriangles(quad), 2u);
  EXPECT_EQ(colourOf(quad.parts[0], 1, 1), (Rgba{0, 255, 51, 255}));
}

TEST_F(PlyLooks, ColoursOfFacesAndVertices) {
  const std::string three = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  const TriangleScene vertices =
      load("m.ply", text("", three, {"1 2 3", "4 5 6", "7 8 9", "0 0 0"}, three, {"3 0 1 2 255 0 0"}));
  EXPECT_EQ(colourOf(vertices.parts[0], 0, 1), (Rgba{4, 5, 6, 255}));
  EXPECT_TRUE(has(vertices.warnings, "those of faces are not used"));
  const TriangleScene faces =
      load("m.ply", text("", three, {"9 9 9", "9 9 9", "9 9 9", "9 9 9"}, three, {"3 0 1 2 255 0 0"}));
  EXPECT_EQ(colourOf(faces.parts[0], 0, 1), (Rgba{255, 0, 0, 255}));
  EXPECT_TRUE(has(faces.warnings, "of all vertices is not used"));
}

TEST_F(PlyLooks, FacesBeforeVerticesHaveTheirColours) {
  const TriangleScene scene = load(
      "m.ply", "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_index\nproperty uchar "
               "red\nproperty uchar green\nproperty uchar blue\nelement vertex 3\nproperty float x\nproperty "
               "float y\nproperty float z\nend_header\n3 2 1 0 9 8 7\n0 0 0\n1 0 0\n0 1 0\n");
  EXPECT_EQ(colourOf(scene.parts[0], 0, 0), (Rgba{9, 8, 7, 255}));
  EXPECT_EQ(trianglesOf(scene)[0], (std::array<ReadCorner, 3>{{{0, 1, 0}, {1, 0, 0}, {0, 0, 0}}}));
}

TEST_F(PlyLooks, TexturesByVertices) {
  folder_.file("my t.tga", kImage);
  for (const auto &[u, v] : {std::pair{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"S", "T"}}) {
    const TriangleScene scene =
        load("m.ply", text("comment TextureFile my t.tga\n",
                           "property float " + std::string(u) + "\nproperty float " + v + "\n",
                           {"0 0", "1 0", "1 0.75", "0 1"}, "", {"4 0 1 2 3"}));
    ASSERT_EQ(scene.textures.size(), 1u) << u;
    EXPECT_EQ(texelsOf(scene.textures[0]), kTexels);
    EXPECT_EQ(materialOf(scene, 0).texture.texture, 0);
    EXPECT_EQ(readRow<2>(scene.parts[0].uvs, scene.parts[0].corners(0)[2]), (std::array<double, 2>{1, 0.25}));
    EXPECT_TRUE(scene.warnings.empty());
  }
}

TEST_F(PlyLooks, TexturesByFaces) {
  folder_.file("a.tga", kImage);
  folder_.file("b.tga", kImage);
  const std::string lists = "property list uchar float texcoord\nproperty int texnumber\n";
  const TriangleScene scene =
      load("m.ply", text("comment TextureFile a.tga\ncomment TEXTUREFILE C:\\x\\B.TGA\n", "", {}, lists,
                         {"3 0 1 2 6 0 0 1 0 1 1 1", "3 0 2 3 6 0 0 1 1 0 0.25 0", "3 3 1 2 0 -1",
                          "3 3 1 2 6 0 0 1 0 1 1 2", "3 3 1 2 4 0 0 1 0 1"}));
  ASSERT_EQ(scene.textures.size(), 2u);
  ASSERT_EQ(scene.parts.size(), 3u);
  EXPECT_EQ(materialOf(scene, 0).texture.texture, -1);
  EXPECT_EQ(scene.parts[0].triangles(), 3u);
  EXPECT_EQ(materialOf(scene, 1).texture.texture, 0);
  EXPECT_EQ(trianglesOf(scene)[3], (std::array<ReadCorner, 3>{{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}}));
  EXPECT_EQ(readRow<2>(scene.parts[1].uvs, scene.parts[1].corners(0)[2]), (std::array<double, 2>{0, 0.75}));
  EXPECT_EQ(materialOf(scene, 2).texture.texture, 1);
  EXPECT_EQ(trianglesOf(scene)[4], (std::array<ReadCorner, 3>{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}));
  EXPECT_TRUE(has(scene.warnings, "2 faces are without a texture"));
  EXPECT_TRUE(has(scene.warnings, "'C:\\x\\B.TGA' is not there"));
}

TEST_F(PlyLooks, CornersOfQuadsKeepTheirCoordinates) {
  folder_.file("a.tga", kImage);
  const TriangleScene scene =
      load("m.ply", text("obj_info TextureFile a.tga\n", "", {}, "property list uchar float texcoord\n",
                         {"4 0 1 2 3 8 0 1 0.25 1 0.5 1 0.75 1"}));
  ASSERT_EQ(countTriangles(scene), 2u);
  for (std::uint64_t i = 0; i < 2; ++i)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const ReadCorner place = trianglesOf(scene)[i][corner];
      const double u = place[1] == 0 ? 0.25 * place[0] : 0.75 - 0.25 * place[0];
      EXPECT_EQ(readRow<2>(scene.parts[0].uvs, scene.parts[0].corners(i)[corner]),
                (std::array<double, 2>{u, 0}));
    }
}

TEST_F(PlyLooks, VertexCoordinatesWithTexturesOfFaces) {
  folder_.file("a.tga", kImage);
  folder_.file("b.tga", kImage);
  const TriangleScene scene =
      load("m.ply", text("comment TextureFile a.tga\ncomment TextureFile b.tga\n",
                         "property float u\nproperty float v\n", {"0 0", "1 0", "1 0.75", "0 1"},
                         "property int texnumber\n", {"3 0 1 2 1", "3 0 2 3 0"}));
  ASSERT_EQ(scene.parts.size(), 2u);
  EXPECT_EQ(materialOf(scene, 1).texture.texture, 1);
  EXPECT_EQ(readRow<2>(scene.parts[1].uvs, 2), (std::array<double, 2>{1, 0.25}));
}

TEST_F(PlyLooks, TexturesStandInPlaceOfColours) {
  folder_.file("a.tga", kImage);
  const std::string properties =
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float "
      "s\nproperty float t\n";
  const std::array<std::string, 4> rows{"1 2 3 0 0", "1 2 3 0 0", "1 2 3 0 0", "1 2 3 0 0"};
  const TriangleScene there =
      load("m.ply", text("comment TextureFile a.tga\n", properties, rows, "", {"3 0 1 2"}));
  EXPECT_FALSE(there.parts[0].colours);
  EXPECT_TRUE(has(there.warnings, "colours beside textures"));
  const TriangleScene gone =
      load("m.ply", text("comment TextureFile b.tga\n", properties, rows, "", {"3 0 1 2"}));
  EXPECT_EQ(colourOf(gone.parts[0], 0, 0), (Rgba{1, 2, 3, 255}));
  EXPECT_TRUE(has(gone.warnings, "is left out"));
}

TEST_F(PlyLooks, WhatIsNotUsedIsSaid) {
  const std::string content =
      text("", "property float nx\nproperty float quality\nproperty float s\nproperty float t\n",
           {"0 0 0 0", "0 0 0 0", "0 0 0 0", "0 0 0 0"}, "property int flags\n", {"3 0 1 2 7"});
  const std::vector<std::string> warnings = load("m.ply", content).warnings;
  ASSERT_EQ(warnings.size(), 3u);
  EXPECT_TRUE(has(warnings, "1 vertex is left out"));
  EXPECT_TRUE(has(warnings, "'vertex' these properties are not used: quality, s, t"));
  EXPECT_TRUE(has(warnings, "'face' these properties are not used: flags"));
  EXPECT_TRUE(has(load("m.ply", text("comment TextureFile a.tga\n", "", {}, "", {"3 0 1 2"})).warnings,
                  "names the texture 'a.tga', but has no texture coordinates"));
}

} // namespace
} // namespace voxc
