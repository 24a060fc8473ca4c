// Loading of meshes: small files written here, missing parts, and files that are broken.
#include "Source/SourceTesting.h"

#include "voxc/Mesh/TriangleMesh.h"

#include <cstring>

namespace voxc {
namespace {

class MeshLoader : public testing::Test {
protected:
  TriangleMesh load(const std::string &name, const std::string &content) {
    auto mesh = loadMesh(folder_.file(name, content));
    EXPECT_TRUE(mesh) << mesh.error().message;
    return mesh ? *mesh : TriangleMesh{};
  }
  std::string problem(const std::string &name, const std::string &content) {
    auto mesh = loadMesh(folder_.file(name, content));
    return mesh ? "no error" : mesh.error().message;
  }

  TemporaryFolder folder_;
};

/// 2 x 1 texels as an uncompressed TGA from the top: red, then green at half alpha.
const std::string kImage("\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\40\50\0\0\377\377\0\377\0\100", 26);

constexpr const char *kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST_F(MeshLoader, ReadsObjWithMaterials) {
  folder_.file("m.mtl", "newmtl a\nKd 0.5 0.25 1\nd 0.75\nmap_Kd sub\\t.tga\n");
  std::filesystem::create_directory(folder_.path("sub"));
  folder_.file("sub/t.tga", kImage);
  const TriangleMesh mesh = load("m.obj", "mtllib m.mtl\n" + std::string(kTriangle) +
                                              "vt 0 0\nvt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\n");
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_TRUE(mesh.warnings.empty());
  const Material &material = mesh.materials[mesh.triangles[0].material];
  EXPECT_EQ(material.colour, (std::array<float, 4>{0.5f, 0.25f, 1, 0.75f}));
  ASSERT_EQ(material.texture, 0);
  EXPECT_EQ(mesh.textures[0].texels, (std::vector<std::uint32_t>{0xff0000ff, 0x4000ff00}));
  // (0, 0) of an .obj is the low left corner, which the last row touches.
  EXPECT_EQ(mesh.uvs[mesh.triangles[0].vertices[0]], (Float2{0, 1}));
}

TEST_F(MeshLoader, NoMaterialIsWhite) {
  const TriangleMesh mesh = load("m.obj", std::string(kTriangle) + "f 1 2 3\n");
  EXPECT_EQ(mesh.materials[mesh.triangles[0].material].colour, (std::array<float, 4>{1, 1, 1, 1}));
}

TEST_F(MeshLoader, MissingAndBrokenPartsAreWarnings) {
  folder_.file("m.mtl", "newmtl a\nmap_Kd none.png\nmap_d broken.png\n");
  folder_.file("broken.png", "not an image");
  TriangleMesh mesh = load("m.obj", "mtllib m.mtl\n" + std::string(kTriangle) + "usemtl a\nf 1 2 3\n");
  ASSERT_EQ(mesh.warnings.size(), 2u);
  EXPECT_NE(mesh.warnings[0].find("none.png"), std::string::npos);
  EXPECT_NE(mesh.warnings[1].find("broken.png"), std::string::npos);
  mesh = load("n.obj", "mtllib nowhere.mtl\n" + std::string(kTriangle) + "usemtl a\nf 1 2 3\n");
  ASSERT_FALSE(mesh.warnings.empty());
  EXPECT_NE(mesh.warnings[0].find("nowhere.mtl"), std::string::npos);
}

TEST_F(MeshLoader, AppliesNodesAndInstances) {
  // One triangle, twice: moved by 10 along x, and scaled by 2 below a node that moves by 5 along y.
  std::string buffer;
  for (const float coordinate : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f})
    buffer.append(reinterpret_cast<const char *>(&coordinate), 4);
  folder_.file("b.bin", buffer);
  const TriangleMesh mesh = load("m.gltf", R"({"asset":{"version":"2.0"},"scene":0,
    "scenes":[{"nodes":[0,1]}],
    "nodes":[{"mesh":0,"translation":[10,0,0]},{"translation":[0,5,0],"children":[2]},{"mesh":0,"scale":[2,2,2]}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
    "bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"uri":"b.bin","byteLength":36}]})");
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.positions[1], (Float3{11, 0, 0}));
  EXPECT_EQ(mesh.positions[4], (Float3{2, 5, 0}));
}

TEST_F(MeshLoader, ReadsStl) {
  const TriangleMesh mesh =
      load("m.stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                    "vertex 0 1 0\nendloop\nendfacet\nendsolid s\n");
  EXPECT_EQ(mesh.triangles.size(), 1u);
}

constexpr const char *kPlyVertices =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nproperty uchar red\nproperty uchar green\n"
    "property uchar blue\n";
constexpr const char *kPlyRows = "0 0 0 1 2 3\n1 0 0 4 5 6\n1 1 0 7 8 9\n0 1 0 10 11 12\n";

TEST_F(MeshLoader, ReadsPlyFacesAsFans) {
  const TriangleMesh mesh =
      load("m.ply", std::string(kPlyVertices) + "element face 1\nproperty list uchar int " +
                        "vertex_index\nend_header\n" + kPlyRows + "4 0 1 2 3\n");
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.triangles[1].vertices, (std::array<std::uint32_t, 3>{0, 2, 3}));
  EXPECT_EQ(mesh.colours[3], 0xff0c0b0au);
}

TEST_F(MeshLoader, BrokenPlyMeshesAreErrors) {
  const std::string head = std::string(kPlyVertices) +
                           "element face 1\nproperty list uchar int vertex_index\nend_header\n" + kPlyRows;
  EXPECT_NE(problem("m.ply", head + "3 0 1 4\n").find("names vertex 4"), std::string::npos);
  EXPECT_NE(problem("m.ply", head + "3 0 1 -1\n").find("names vertex -1"), std::string::npos);
  EXPECT_NE(problem("m.ply", head + "200 0 1 2\n").find("cut short"), std::string::npos);
  EXPECT_NE(problem("m.ply", head + "2 0 1\n").find("no triangle"), std::string::npos);
  EXPECT_NE(problem("m.ply", std::string(kPlyVertices) + "element face 1\nproperty int flags\nend_header\n" +
                                 kPlyRows + "1\n")
                .find("vertex_indices"),
            std::string::npos);
  EXPECT_NE(problem("m.ply", std::string(kPlyVertices) +
                                 "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" +
                                 kPlyRows + "3 0 1 2\n")
                .find("strips"),
            std::string::npos);
}

TEST_F(MeshLoader, BrokenFilesAreErrors) {
  for (const char *name : {"m.obj", "m.glb", "m.gltf", "m.stl", "m.ply"}) {
    EXPECT_NE(problem(name, ""), "no error") << name;
    EXPECT_NE(problem(name, "nonsense\nin\nlines\n"), "no error") << name;
  }
  EXPECT_NE(problem("m.obj", std::string(kTriangle) + "f 1 2 9\n"), "no error");
  EXPECT_NE(problem("m.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"), "no error");
  EXPECT_NE(problem("m.obj", kTriangle), "no error");
  EXPECT_FALSE(loadMesh(folder_.path("")));
}

} // namespace
} // namespace voxc
