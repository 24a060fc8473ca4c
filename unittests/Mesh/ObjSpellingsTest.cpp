// .obj and .mtl files as other programs spell them: options, letters, names of files, colours to 255.
#include "LoadTesting.h"

namespace voxc {
namespace {

using Colour = std::array<float, 4>;

const std::string kTexturedTriangle =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\n";

class ObjSpellings : public LoadTest {
protected:
  /// Loads a triangle with the material `a` of this library.
  TriangleScene loadWith(const std::string &library) {
    folder_.file("m.mtl", library);
    return load("m.obj", "mtllib m.mtl\n" + kTexturedTriangle);
  }
  Material materialWith(const std::string &library) { return materialOf(loadWith(library), 0); }
  std::vector<std::string> warningsWith(const std::string &library) { return loadWith(library).warnings; }
};

TEST_F(ObjSpellings, BlackBesideATextureIsWhite) {
  folder_.file("t.tga", kImage);
  const TriangleScene scene = loadWith("newmtl a\nKd 0.00 0.00 0.00\nTf 1 1 1\nmap_Kd t.tga\nd 0.5\n");
  EXPECT_EQ(materialOf(scene, 0).colour, (Colour{1, 1, 1, 0.5f}));
  EXPECT_EQ(scene.warnings.size(), 1u);
  EXPECT_TRUE(has(scene.warnings, "'a' has the Kd 0 beside a texture"));
  // Without a texture that is there, and for what is merely dark, the colour is the colour.
  EXPECT_EQ(materialWith("newmtl a\nKd 0 0 0\nmap_Kd gone.tga\n").colour, (Colour{0, 0, 0, 1}));
  EXPECT_EQ(materialWith("newmtl a\nKd 0 0 0.25\nmap_Kd t.tga\n").colour, (Colour{0, 0, 0.25f, 1}));
}

TEST_F(ObjSpellings, WhollyInvisibleIsOpaque) {
  for (const char *opacity : {"Tr 1.000000", "d 0", "Tr 1\nd 1", "d 1\nTr 1"}) {
    const TriangleScene scene = loadWith("newmtl a\nKd 1 0 0\n" + std::string(opacity) + "\n");
    EXPECT_EQ(materialOf(scene, 0).colour, (Colour{1, 0, 0, 1})) << opacity;
  }
  EXPECT_TRUE(has(warningsWith("newmtl a\nTr 1\n"), "wholly invisible"));
  EXPECT_EQ(materialWith("newmtl a\nTr 0.75\n").colour[3], 0.25f);
  // What `d` says holds, before and behind a `Tr`.
  EXPECT_EQ(materialWith("newmtl a\nd 0.5\nTr 0.25\n").colour[3], 0.5f);
  EXPECT_EQ(materialWith("newmtl a\nTr 0.25\nd 0.5\n").colour[3], 0.5f);
}

TEST_F(ObjSpellings, OptionsThatAreNotKnownAreSkipped) {
  folder_.file("t.tga", kImage);
  for (const char *options : {"-colorspace sRGB", "-COLORSPACE sRGB -clamp on", "-type sphere", "-foo 1 2 3",
                              "-foo bar -s 1 1 1", "-cc on", "-mm 0 1 -boost 2 -texres 512 -bm 0.5"}) {
    const TriangleScene scene = loadWith("newmtl a\nmap_Kd " + std::string(options) + " t.tga\n");
    EXPECT_EQ(scene.textures.size(), 1u) << options;
    const bool isPlain = std::string_view(options).find("sRGB") != std::string_view::npos ||
                         std::string_view(options).starts_with("-mm");
    EXPECT_EQ(scene.warnings.empty(), isPlain) << options;
  }
  EXPECT_TRUE(has(warningsWith("newmtl a\nmap_Kd -foo bar -type cube t.tga\n"), "not used: -foo, -type"));
  folder_.file("-my t.tga", kImage);
  EXPECT_EQ(loadWith("newmtl a\nmap_Kd -my t.tga\n").textures.size(), 1u);
}

TEST_F(ObjSpellings, WordsInAnyCase) {
  folder_.file("t.tga", kImage);
  const TriangleScene scene = loadWith("NewMtl a\nkd 0.5 0.25 1\nD 0.5\nmap_KD -S 2 2 1 t.tga\n");
  EXPECT_EQ(materialOf(scene, 0).colour, (Colour{0.5f, 0.25f, 1, 0.5f}));
  EXPECT_EQ(materialOf(scene, 0).texture.matrix[0], 2);
  EXPECT_TRUE(scene.warnings.empty());
  const TriangleScene model = load("n.obj", "MTLLIB m.mtl\nV 0 0 0\nv 1 0 0\nv 0 1 0\nUseMtl A\nF 1 2 3\n");
  EXPECT_EQ(materialOf(model, 0).colour[2], 1);
  EXPECT_TRUE(has(model.warnings, "'A' is not defined; 'a' stands in for it"));
}

TEST_F(ObjSpellings, MarksOfUtf8ArePassedOver) {
  folder_.file("m.mtl", "\xef\xbb\xbfnewmtl a\nKd 0 1 0\n");
  const TriangleScene scene = load("m.obj", "\xef\xbb\xbfmtllib m.mtl\n" + kTexturedTriangle);
  EXPECT_EQ(materialOf(scene, 0).colour, (Colour{0, 1, 0, 1}));
  EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(ObjSpellings, WhatIsNotUsedIsSaidOnce) {
  folder_.file("t.tga", kImage);
  const std::vector<std::string> warnings = warningsWith(
      "newmtl a\nKa 1 1 1\nKs 1 1 1\nNs 10\nNi 1\nillum 2\nKe 0 0 0\nmap_Ka t.tga\nmap_Kd t.tga\n"
      "# map_x\nnewmtl b\nKe 1 0 0\nmap_Bump t.tga\nmap_Bump t.tga\nPm 0\nnewmtl c\nmap_Ka t.tga\n");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(has(warnings, "'m.mtl' these are not used: map_Bump, map_Ka"));
  EXPECT_TRUE(has(load("m.obj", kTexturedTriangle + "vn 0 0 1\ng x\nusemap x\nfoo 1\nfoo 2\n").warnings,
                  "passed over: 'foo', 'usemap'"));
}

TEST_F(ObjSpellings, LibrariesBesideTheModel) {
  folder_.file("my lib rary.mtl", "newmtl a\nKd 0 1 0\n");
  for (const char *name :
       {"my\\ lib\\ rary.mtl", "\"my lib rary.mtl\"", "my lib rary.mtl", "My Lib Rary.MTL",
        "C:\\models\\my lib rary.mtl", "/nowhere/my\\ lib\\ rary.mtl", "my%20lib%20rary.mtl",
        "./my lib rary.mtl # of mine", "x.mtl my\\ lib\\ rary.mtl \"x y.mtl\""}) {
    const TriangleScene scene = load("m.obj", "mtllib " + std::string(name) + "\n" + kTexturedTriangle);
    EXPECT_EQ(materialOf(scene, 0).colour, (Colour{0, 1, 0, 1})) << name;
  }
  const TriangleScene moved = load("m.obj", "mtllib C:\\models\\my lib rary.mtl\n" + kTexturedTriangle);
  ASSERT_EQ(moved.warnings.size(), 1u);
  EXPECT_TRUE(has(moved.warnings, "beside the model is taken"));
}

TEST_F(ObjSpellings, TheLibraryThatIsCalledAsTheModel) {
  folder_.file("own.mtl", "newmtl a\nKd 0 0 1\n");
  for (const char *line : {"mtllib gone.mtl\n", ""}) {
    const TriangleScene scene = load("own.obj", line + kTexturedTriangle);
    EXPECT_EQ(materialOf(scene, 0).colour, (Colour{0, 0, 1, 1}));
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_TRUE(has(scene.warnings, "'own.mtl' beside it is taken"));
  }
  EXPECT_TRUE(
      has(load("other.obj", "mtllib gone.mtl\n" + kTexturedTriangle).warnings, "'gone.mtl' cannot be read"));
}

TEST_F(ObjSpellings, ImagesBesideTheModel) {
  std::filesystem::create_directory(folder_.path("Maps"));
  folder_.file("Maps/one two.tga", kImage);
  folder_.file("t.tga", kImage);
  std::filesystem::create_directory(folder_.path("textures"));
  folder_.file("textures/three.tga", kImage);
  for (const char *name :
       {"T.TGA", "t.tga -clamp on", "\"t.tga\" # of mine", "C:\\Users\\x\\t.tga", "/home/x/t.tga",
        "\"t.tga\"", "maps\\ONE two.tga", "Maps/one\\ two.tga", "\"Maps/one two.tga\"", "file:///C:/x/T.tga",
        "textures/t.tga", "\"C:\\my docs\\maps\\one two.tga\"", "three.tga", "/home/x/y/three.tga"}) {
    const TriangleScene scene = loadWith("newmtl a\nmap_Kd " + std::string(name) + "\n");
    ASSERT_EQ(scene.textures.size(), 1u) << name;
    EXPECT_EQ(texelsOf(scene.textures[0]), kTexels);
    ASSERT_EQ(scene.files.size(), 2u) << name;
    EXPECT_EQ(scene.files[0], folder_.path("m.mtl"));
    EXPECT_TRUE(std::filesystem::is_regular_file(scene.files[1])) << scene.files[1];
  }
  EXPECT_TRUE(has(warningsWith("newmtl a\nmap_Kd D:\\t.tga\n"), "'D:\\t.tga' is not there"));
  EXPECT_TRUE(warningsWith("newmtl a\nmap_Kd T.TGA\n").empty());
  EXPECT_TRUE(has(warningsWith("newmtl a\nmap_Kd D:\\gone.tga\n"), "is left out: cannot read"));
}

/// The colour of the first corner, in bytes, of a triangle whose colours are these.
std::array<int, 3> bytesOfFirst(const TriangleScene &scene) {
  const std::array<double, 4> colour = readRow<4>(scene.parts[0].colours, 0);
  return {static_cast<int>(colour[0] * 255 + 0.5), static_cast<int>(colour[1] * 255 + 0.5),
          static_cast<int>(colour[2] * 255 + 0.5)};
}

TEST_F(ObjSpellings, ColoursOfVerticesCountToTheirLargest) {
  const auto model = [](const std::string &first, const std::string &second) {
    return "v 0 0 0 " + first + "\nv 1 0 0 " + second + "\nv 0 1 0\nf 1 2 3\n";
  };
  using Bytes = std::array<int, 3>;
  const TriangleScene bytes = load("m.obj", model("1 100 50", "255 0 0"));
  EXPECT_EQ(bytesOfFirst(bytes), (Bytes{1, 100, 50}));
  EXPECT_EQ(readRow<4>(bytes.parts[0].colours, 2), (std::array<double, 4>{1, 1, 1, 1}));
  EXPECT_TRUE(has(bytes.warnings, "count to 255"));
  EXPECT_EQ(bytesOfFirst(load("m.obj", model("1 100.4 50", "200.5 0 0"))), (Bytes{1, 100, 50}));
  EXPECT_EQ(bytesOfFirst(load("m.obj", model("257 0 65535", "0 0 0"))), (Bytes{1, 0, 255}));
  EXPECT_EQ(bytesOfFirst(load("m.obj", model("1 0 0.2", "0 0 1"))), (Bytes{255, 0, 51}));
  const TriangleScene bright = load("m.obj", model("0.2 0 1.5", "0 0 0"));
  EXPECT_EQ(bytesOfFirst(bright), (Bytes{51, 0, 255}));
  EXPECT_TRUE(has(bright.warnings, "above 1, and are cut"));
}

TEST_F(ObjSpellings, PaintOfZBrush) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const TriangleScene scene = load("m.obj", vertices + "#MRGB ffc86432ff0a141e\n#MRGB 00ff0000\nf 1 2 3\n");
  EXPECT_EQ(bytesOfFirst(scene), (std::array<int, 3>{200, 100, 50}));
  EXPECT_EQ(readRow<4>(scene.parts[0].colours, 2), (std::array<double, 4>{1, 0, 0, 1}));
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_TRUE(has(load("m.obj", vertices + "f 1 2 3\n#MRGB ffc86432\n").warnings, "are not used"));
  EXPECT_TRUE(has(load("m.obj", "#MRGB ffc86432\n" + vertices + "f 1 2 3\n").warnings, "are not used"));
  EXPECT_FALSE(load("m.obj", vertices + "#MRGB what\nf 1 2 3\n").parts[0].colours);
}

TEST_F(ObjSpellings, ColoursOfMaterialsCountToTheirLargest) {
  const TriangleScene scene = loadWith("newmtl a\nKd 204 102 0\n");
  EXPECT_EQ(materialOf(scene, 0).colour, (Colour{0.8f, 0.4f, 0, 1}));
  EXPECT_TRUE(has(scene.warnings, "line 2 of the material library 'm.mtl' has a colour above 1"));
}

TEST_F(ObjSpellings, TextureCoordinatesThatDoNotExistAreNone) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const char *face : {"f 1/1/1 2/2/1 3/3/1\n", "f 1/0 2/-7 3/9\n"}) {
    const TriangleScene scene = load("m.obj", vertices + face);
    EXPECT_EQ(countTriangles(scene), 1u);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_TRUE(has(scene.warnings, "texture coordinates that do not exist are named by 3 corners of faces"));
  }
  // A face that lacks one has none; others keep theirs.
  const TriangleScene some = load("m.obj", vertices + "vt 0.5 0.25\nf 1/1 2/2 3/1\nf 3/1 2/1 1/1\n");
  EXPECT_TRUE(has(some.warnings, "1 corner of faces"));
  ASSERT_EQ(some.parts.size(), 2u);
  EXPECT_FALSE(some.parts[0].uvs);
  EXPECT_EQ(readRow<2>(some.parts[1].uvs, some.parts[1].corners(0)[0]), (std::array<double, 2>{0.5, 0.75}));
}

TEST_F(ObjSpellings, TexturesWithoutCoordinatesAreSaid) {
  folder_.file("t.tga", kImage);
  folder_.file("m.mtl", "newmtl a\nmap_Kd t.tga\n");
  const std::string model = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
  EXPECT_TRUE(has(load("m.obj", model).warnings, "has no texture coordinates"));
}

TEST_F(ObjSpellings, VerticesWithoutFacesArePoints) {
  const TriangleScene scene = load("m.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\n");
  ASSERT_EQ(countTriangles(scene), 3u);
  EXPECT_EQ(scene.parts[0].mode, PrimitiveMode::Points);
  EXPECT_EQ(readRow<4>(scene.parts[0].colours, 1), (std::array<double, 4>{0, 1, 0, 1}));
  EXPECT_EQ(load("m.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\np 2\n").parts[0].triangles(), 1u);
}

/// Text as another encoding has it: a mark, and bytes of 0 before or behind each letter.
std::string wide(const std::string &text, const std::string &mark, std::size_t before, std::size_t behind) {
  std::string bytes = mark;
  for (const char c : text)
    bytes += std::string(before, '\0') + c + std::string(behind, '\0');
  return bytes;
}

TEST_F(ObjSpellings, TextOfUtf16IsCalledThat) {
  for (const std::string mark : {"\xff\xfe", ""}) {
    EXPECT_NE(problem("m.obj", wide(kTexturedTriangle, mark, 0, 1)).find("it is UTF-16 text"),
              std::string::npos);
    EXPECT_NE(problem("m.obj", wide(kTexturedTriangle, mark.empty() ? "" : "\xfe\xff", 1, 0))
                  .find("save it as UTF-8"),
              std::string::npos);
  }
  EXPECT_NE(problem("m.obj", wide(kTexturedTriangle, std::string("\xff\xfe\0\0", 4), 0, 3))
                .find("it is UTF-32 text"),
            std::string::npos);
  const std::vector<std::string> warnings = warningsWith(wide("newmtl a\nKd 1 0 0\n", "\xff\xfe", 0, 1));
  EXPECT_TRUE(has(warnings, "the material library 'm.mtl' is not used: it is UTF-16 text"));
}

TEST_F(ObjSpellings, SevenNumbersOfAVertex) {
  const std::string face = "f 1 2 3\n";
  // A colour with alpha, as programs write it; the fourth is not always 1.
  const TriangleScene scene =
      load("m.obj", "v 0 0 0 1 0.5 0 1\nv 1 0 0 0 1 0 0.5\nV 0 1 0 1 1 1 1 # 7\n" + face);
  EXPECT_EQ(readRow<4>(scene.parts[0].colours, 1), (std::array<double, 4>{0, 1, 0, 1}));
  EXPECT_EQ(readRow<4>(scene.parts[0].colours, 2), (std::array<double, 4>{1, 1, 1, 1}));
  EXPECT_EQ(scene.warnings.size(), 1u);
  EXPECT_TRUE(has(scene.warnings, "x, y, z, red, green, blue and alpha"));
  const TriangleScene bytes =
      load("m.obj", "v 0 0 0 255 0 0 255\nv 1 0 0 255 0 0 255\nv 0 1 0 0 51 0 255\n" + face);
  EXPECT_EQ(readRow<4>(bytes.parts[0].colours, 2), (std::array<double, 4>{0, 0.2, 0, 1}));
  // A weight and a colour.
  const TriangleScene weights = load("m.obj", "v 0 0 0 1 0 0 1\nv 1 0 0\nv 0 1 0 1.0 0 1 0\n" + face);
  EXPECT_EQ(readRow<4>(weights.parts[0].colours, 0), (std::array<double, 4>{0, 0, 1, 1}));
  EXPECT_EQ(readRow<4>(weights.parts[0].colours, 2), (std::array<double, 4>{0, 1, 0, 1}));
  EXPECT_TRUE(weights.warnings.empty());
}

} // namespace
} // namespace voxc
