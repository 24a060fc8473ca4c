// .obj files with their material libraries.
#include "LoadTesting.h"

namespace voxc {
namespace {

class ObjReader : public LoadTest {};

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST_F(ObjReader, ReadsMaterials) {
  folder_.file("m.mtl", "newmtl a\nKd 0.5 0.25 1\nd 0.75\nmap_Kd sub\\t x.tga\nnewmtl b\nKd 0.5\nTr 0.25\n");
  std::filesystem::create_directory(folder_.path("sub"));
  folder_.file("sub/t x.tga", kImage);
  const TriangleScene scene = load(
      "m.obj",
      "mtllib m.mtl\n" + kTriangle +
          "vt 0 0\nvt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 3 2 1\nusemtl a\nf 3/3 2/2 1/1\n");
  ASSERT_EQ(scene.parts.size(), 3u);
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(materialOf(scene, 0).colour, (std::array<float, 4>{0.5f, 0.25f, 1, 0.75f}));
  EXPECT_EQ(materialOf(scene, 1).colour, (std::array<float, 4>{0.5f, 0.5f, 0.5f, 0.75f}));
  EXPECT_EQ(scene.parts[2].material, scene.parts[0].material);
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(materialOf(scene, 0).texture.texture, 0);
  EXPECT_EQ(texelsOf(scene.textures[0]), kTexels);
  // (0, 0) of an .obj is the low left corner, which the last row touches.
  EXPECT_EQ(readRow<2>(scene.parts[0].uvs, scene.parts[0].corners(0)[0]), (std::array<double, 2>{0, 1}));
  EXPECT_EQ(readRow<2>(scene.parts[0].uvs, scene.parts[0].corners(0)[2]), (std::array<double, 2>{0, 0}));
}

TEST_F(ObjReader, TextureOptions) {
  folder_.file("t.tga", kImage);
  folder_.file("m.mtl", "newmtl a\nmap_Kd -blendu on -clamp on -s 2 3 1 -o 0.5 0.25 -bm 1 t.tga\n"
                        "map_d -imfchan r t.tga\nnewmtl b\nmap_d t.tga\n");
  const TriangleScene scene = load("m.obj", "mtllib m.mtl\n" + kTriangle +
                                                "vt 0 0\nusemtl a\nf 1/1 2/1 3/1\nusemtl b\nf 1/1 2/1 3/1\n");
  const TextureUse &use = materialOf(scene, 0).texture;
  EXPECT_EQ(use.wrap[0], TextureWrap::ClampToEdge);
  EXPECT_EQ(use.wrap[1], TextureWrap::ClampToEdge);
  // From above: 1 - (3 (1 - v) + 0.25).
  EXPECT_EQ(use.matrix, (std::array<float, 6>{2, 0, 0.5f, 0, 3, -2.25f}));
  // A mask that is the texture itself says nothing new.
  EXPECT_EQ(materialOf(scene, 0).alphaMask.texture, -1);
  EXPECT_EQ(materialOf(scene, 1).alphaMask.texture, 0);
  EXPECT_EQ(scene.textures.size(), 1u);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(ObjReader, MasksAreOfAChannel) {
  folder_.file("t.tga", kImage);
  const std::string model = "mtllib m.mtl\n" + kTriangle + "vt 0 0\nusemtl a\nf 1/1 2/1 3/1\n";
  const auto channelOf = [&](const std::string &channel) {
    folder_.file("m.mtl", "newmtl a\nmap_d -imfchan " + channel + " t.tga\n");
    const TriangleScene scene = load("m.obj", model);
    EXPECT_EQ(materialOf(scene, 0).alphaMask.texture, 0);
    return std::pair(int(materialOf(scene, 0).alphaChannel), scene.warnings.size());
  };
  EXPECT_EQ(channelOf("r"), std::pair(0, std::size_t{0}));
  EXPECT_EQ(channelOf("b"), std::pair(2, std::size_t{0}));
  EXPECT_EQ(channelOf("m"), std::pair(3, std::size_t{0}));
  EXPECT_EQ(channelOf("l"), std::pair(0, std::size_t{1}));
}

TEST_F(ObjReader, NoMaterialIsWhite) {
  const TriangleScene scene = load("m.obj", kTriangle + "f 1 2 3\n");
  EXPECT_EQ(materialOf(scene, 0).colour, (std::array<float, 4>{1, 1, 1, 1}));
  EXPECT_FALSE(scene.parts[0].uvs);
  EXPECT_FALSE(scene.parts[0].colours);
}

TEST_F(ObjReader, VertexColours) {
  const TriangleScene scene = load("m.obj", "v 0 0 0\nv 1 0 0 1 0.2 0\nv 0 1 0 1.0 0 0 1\nf 1 2 3\n");
  const MeshPart &part = scene.parts[0];
  const auto colour = [&](std::size_t corner) { return readRow<4>(part.colours, part.corners(0)[corner]); };
  EXPECT_EQ(colour(0), (std::array<double, 4>{1, 1, 1, 1}));
  EXPECT_EQ(colour(1), (std::array<double, 4>{1, 0.2, 0, 1}));
  EXPECT_EQ(colour(2), (std::array<double, 4>{0, 0, 1, 1}));
}

TEST_F(ObjReader, IndicesOfAllForms) {
  const TriangleScene scene = load("m.obj", "#c\n\n" + kTriangle +
                                                "vt 0.5 0.5\nvn 0 0 1\r\nf 1/1/1 2//1 \\\n"
                                                " 3/1\t\nf -3/1 -2/-1 -1/-1/1 # c\n  f 1 2 3\n");
  const auto triangles = trianglesOf(scene);
  ASSERT_EQ(triangles.size(), 3u);
  EXPECT_EQ(triangles[0], triangles[1]);
  EXPECT_EQ(triangles[0], triangles[2]);
  EXPECT_EQ(triangles[0][1], (ReadCorner{1, 0, 0}));
  // The face with all of its texture coordinates stands between two that lack some.
  ASSERT_EQ(scene.parts.size(), 3u);
  const MeshPart &part = scene.parts[1];
  EXPECT_EQ(readRow<2>(part.uvs, part.corners(0)[1]), (std::array<double, 2>{0.5, 0.5}));
}

TEST_F(ObjReader, VerticesAreShared) {
  const TriangleScene scene = load("m.obj", kTriangle + "v 1 1 0\nf 1 2 3\nf 3 2 4\n");
  EXPECT_EQ(scene.parts[0].positions.count, 4u);
}

TEST_F(ObjReader, LinesAndPoints) {
  const TriangleScene scene = load("m.obj", kTriangle + "l 1 2 3\np 3\nf 1 2 3\nl 3 1\n");
  ASSERT_EQ(scene.parts.size(), 4u);
  const auto triangles = trianglesOf(scene);
  ASSERT_EQ(triangles.size(), 5u);
  EXPECT_EQ(triangles[1], (std::array<ReadCorner, 3>{{{1, 0, 0}, {0, 1, 0}, {0, 1, 0}}}));
  EXPECT_EQ(triangles[2], (std::array<ReadCorner, 3>{{{0, 1, 0}, {0, 1, 0}, {0, 1, 0}}}));
  EXPECT_EQ(triangles[4], (std::array<ReadCorner, 3>{{{0, 1, 0}, {0, 0, 0}, {0, 0, 0}}}));
}

TEST_F(ObjReader, ManyChangesOfMaterialMakeFewParts) {
  std::string text = kTriangle + "v 7 7 7\n";
  for (int i = 0; i < 40000; ++i)
    text += i == 39999 ? "usemtl a\nf 1 2 3\nusemtl b\nf 4 3 2\n" : "usemtl a\nf 1 2 3\nusemtl b\nf 3 2 1\n";
  const TriangleScene scene = load("m.obj", text);
  ASSERT_EQ(scene.parts.size(), 2u);
  EXPECT_EQ(scene.parts[0].triangles(), 40000u);
  EXPECT_EQ(scene.parts[1].triangles(), 40000u);
  EXPECT_NE(scene.parts[0].material, scene.parts[1].material);
  EXPECT_EQ(trianglesOf(scene)[79999][0], (ReadCorner{7, 7, 7}));
  EXPECT_EQ(trianglesOf(scene)[39999][0], (ReadCorner{0, 0, 0}));
}

TEST_F(ObjReader, SeveralLibrariesInALine) {
  folder_.file("a.mtl", "newmtl a\nKd 1 0 0\n");
  folder_.file("b c.mtl", "newmtl b\nKd 0 1 0\n");
  folder_.file("d.mtl", "newmtl d\nKd 0 0 1\n");
  const TriangleScene scene = load("m.obj", "mtllib b c.mtl\nmtllib a.mtl d.mtl\n" + kTriangle +
                                                "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl d\nf 1 2 3\n");
  EXPECT_TRUE(scene.warnings.empty());
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<float, 4> colour{0, 0, 0, 1};
    colour[i] = 1;
    EXPECT_EQ(materialOf(scene, i).colour, colour);
  }
}

TEST_F(ObjReader, StopsWhenAsked) {
  const std::atomic<bool> stop = true;
  Progress progress;
  progress.stop = &stop;
  const auto scene = loadScene(folder_.file("m.obj", kTriangle + "f 1 2 3\n"), memory_, progress);
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().kind, ErrorKind::Interrupted);
}

} // namespace
} // namespace voxc
