// .gltf and .glb: where parts are and of what.
#include "LoadTesting.h"

namespace voxc {
namespace {

/// Positions of a square, its two triangles as 16-bit indices, texture coordinates, colours.
const std::string kPositions = bytesOf({0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.f});
const std::string kIndices = bytesOf<std::uint16_t>({0, 1, 2, 0, 2, 3});
const std::string kUvs = bytesOf<std::uint16_t>({0, 0, 65535, 0, 65535, 65535, 0, 65535});
const std::string kColours = bytesOf<std::uint8_t>({255, 51, 0, 255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 255});
const std::string kBuffer = kPositions + kIndices + kUvs + kColours + kImage;

class GltfReader : public LoadTest {
protected:
  /// A model with the buffer above in a file: accessors 0 to 3 are its four arrays; `rest` has at least nodes
  /// and meshes.
  static std::string model(const std::string &rest, const std::string &buffer = R"("uri":"b%20c.bin",)") {
    return R"({"asset":{"version":"2.0"},)" + rest + R"(,
      "accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
        {"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"},
        {"bufferView":2,"componentType":5123,"normalized":true,"count":4,"type":"VEC2"},
        {"bufferView":3,"componentType":5121,"normalized":true,"count":4,"type":"VEC4"},
        {"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":1,
          "indices":{"bufferView":1,"byteOffset":4,"componentType":5123},"values":{"bufferView":0,"byteOffset":12}}},
        {"bufferView":0,"componentType":5126,"count":6,"type":"VEC2"},
        {"componentType":5126,"count":2,"type":"VEC3"}],
      "bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12},
        {"buffer":0,"byteOffset":60,"byteLength":16},{"buffer":0,"byteOffset":76,"byteLength":16},
        {"buffer":0,"byteOffset":92,"byteLength":26}],
      "buffers":[{)" +
           buffer + R"("byteLength":118}]})";
  }

  TriangleScene loadModel(const std::string &rest) {
    folder_.file("b c.bin", kBuffer);
    return load("m.gltf", model(rest));
  }

  TriangleScene loadMaterial(const std::string &material, const std::string &rest = "") {
    return loadModel(R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"material":0,
      "attributes":{"POSITION":0,"TEXCOORD_0":2,"TEXCOORD_1":5},"indices":1}]}],"materials":[)" +
                     material + "]" + rest);
  }
};

const std::string kOneNode = R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},)";

TEST_F(GltfReader, NodesAndInstances) {
  // A square, twice: moved by 10 along x, and scaled by 2 below a node that moves by 5 along y.
  const TriangleScene scene = loadModel(R"("scene":0,"scenes":[{"nodes":[0,1]}],
    "nodes":[{"mesh":0,"translation":[10,0,0]},{"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,5,0,1],"children":[2]},
      {"mesh":0,"scale":[2,2,2]},{"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}])");
  EXPECT_EQ(scene.parts.size(), 1u);
  const auto triangles = trianglesOf(scene);
  ASSERT_EQ(triangles.size(), 4u);
  EXPECT_EQ(triangles[0], (std::array<ReadCorner, 3>{{{10, 0, 0}, {11, 0, 0}, {11, 1, 0}}}));
  EXPECT_EQ(triangles[3], (std::array<ReadCorner, 3>{{{0, 5, 0}, {2, 7, 0}, {0, 7, 0}}}));
}

TEST_F(GltfReader, NoSceneIsAllRoots) {
  const TriangleScene scene = loadModel(R"("nodes":[{"mesh":0},{"mesh":0,"children":[0]},
    {"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}])");
  EXPECT_EQ(scene.instances.size(), 3u);
}

TEST_F(GltfReader, RotationComesBetweenScaleAndTranslation) {
  // A quarter of a turn about z; the quaternion need not have length 1.
  const TriangleScene scene = loadModel(R"("nodes":[{"mesh":0,"translation":[0,0,7],"rotation":[0,0,2,2],
    "scale":[3,1,1]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}])");
  const ReadCorner corner = trianglesOf(scene)[0][1];
  EXPECT_NEAR(corner[0], 0, 1e-12);
  EXPECT_NEAR(corner[1], 3, 1e-12);
  EXPECT_EQ(corner[2], 7);
}

TEST_F(GltfReader, RotationOfAnyQuaternion) {
  // The second node turns x to y, y to z and z to x first.
  const TriangleScene scene = loadModel(R"("nodes":[{"mesh":0,"rotation":[1,2,3,4],"scale":[3,6,9]},
    {"rotation":[1,2,3,4],"scale":[3,6,9],"children":[2]},{"mesh":0,"matrix":[0,1,0,0,0,0,1,0,1,0,0,0,0,0,0,1]}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}])");
  const auto triangles = trianglesOf(scene);
  const std::array<ReadCorner, 2> expected{{{-3.6, 4.8, 3}, {2.6, 3.2, 10}}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(triangles[0][2][axis], expected[0][axis], 1e-12);
    EXPECT_NEAR(triangles[2][2][axis], expected[1][axis], 1e-12);
  }
}

TEST_F(GltfReader, DeepTreesAreNoProblem) {
  const int depth = 20000;
  std::string nodes = R"("nodes":[{"mesh":0})";
  for (int i = 0; i < depth; ++i)
    nodes += R"(,{"translation":[1,0,0],"children":[)" + std::to_string(i) + "]}";
  const TriangleScene scene =
      loadModel(nodes + R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}])");
  EXPECT_EQ(trianglesOf(scene)[0][0], (ReadCorner{depth, 0, 0}));
}

TEST_F(GltfReader, BuffersAreNotCopied) {
  const TriangleScene scene = loadModel(kOneNode + R"("indices":1}]}])");
  const MeshPart &part = scene.parts[0];
  EXPECT_EQ(part.indices.data - part.positions.data, 48);
}

TEST_F(GltfReader, DataUris) {
  const TriangleScene scene = load("m.gltf", R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
    "accessors":[{"bufferView":0,"componentType":5120,"count":3,"type":"VEC3"}],
    "bufferViews":[{"buffer":0,"byteLength":12,"byteStride":4,"byteOffset":1}],
    "buffers":[{"byteLength":13,"uri":"data:;base64,/wECAwAEBQYAB/j//w=="}]})");
  EXPECT_EQ(trianglesOf(scene)[0], (std::array<ReadCorner, 3>{{{1, 2, 3}, {4, 5, 6}, {7, -8, -1}}}));
}

TEST_F(GltfReader, BinaryChunk) {
  std::string json = model(kOneNode + R"("indices":1}]}])", "");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string binary = kBuffer;
  binary.resize((binary.size() + 3) / 4 * 4);
  const auto word = [](std::size_t value) { return bytesOf({static_cast<std::uint32_t>(value)}); };
  const std::string body =
      word(json.size()) + "JSON" + json + word(binary.size()) + std::string("BIN\0", 4) + binary;
  EXPECT_EQ(countTriangles(load("m.glb", "glTF" + word(2) + word(12 + body.size()) + body)), 2u);
}

TEST_F(GltfReader, EveryMode) {
  const std::array<std::uint64_t, 7> counts{4, 2, 4, 3, 1, 2, 2};
  for (std::size_t mode = 0; mode < counts.size(); ++mode)
    EXPECT_EQ(countTriangles(loadModel(kOneNode + "\"mode\":" + std::to_string(mode) + "}]}]")),
              counts[mode]);
}

TEST_F(GltfReader, SparseRowsReplaceOthers) {
  // The third index is 2: row 2 becomes row 1.
  const TriangleScene scene = loadModel(
      R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":4},"indices":1}]}])");
  EXPECT_EQ(trianglesOf(scene)[0], (std::array<ReadCorner, 3>{{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}}));
}

TEST_F(GltfReader, AccessorsWithoutDataAreZero) {
  const TriangleScene scene =
      loadModel(R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":6},"mode":1}]}])");
  EXPECT_EQ(trianglesOf(scene)[0], (std::array<ReadCorner, 3>{}));
}

TEST_F(GltfReader, ColoursOfVertices) {
  const TriangleScene scene = loadModel(
      R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"COLOR_0":3}}]}])");
  EXPECT_EQ(readRow<4>(scene.parts[0].colours, 0), (std::array<double, 4>{1, 0.2, 0, 1}));
  EXPECT_EQ(scene.materials.size(), 1u);
}

TEST_F(GltfReader, InstancesOfTheGpu) {
  const TriangleScene scene = loadModel(R"("nodes":[{"mesh":0,"translation":[0,0,1],
    "extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":0,"SCALE":0}}}}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}])");
  ASSERT_EQ(scene.instances.size(), 4u);
  EXPECT_EQ(trianglesOf(scene)[4][1], (ReadCorner{2, 1, 1}));
}

TEST_F(GltfReader, TexturedMaterials) {
  const TriangleScene scene = loadMaterial(R"({"alphaMode":"MASK","alphaCutoff":0.25,"pbrMetallicRoughness":{
    "baseColorFactor":[1,0.5,0.25,0.5],"baseColorTexture":{"index":1}}})",
                                           R"(,"textures":[{"source":0},{"source":1,"sampler":0}],
    "samplers":[{"wrapS":33071,"wrapT":33648}],"images":[{"uri":"none.png"},{"bufferView":4}])");
  const Material &material = materialOf(scene, 0);
  EXPECT_EQ(material.colour, (std::array<float, 4>{1, 0.5f, 0.25f, 0.5f}));
  EXPECT_EQ(material.alphaCutoff, 0.25f);
  EXPECT_EQ(material.alpha, AlphaRule::Mask);
  EXPECT_TRUE(material.isLinear);
  EXPECT_EQ(material.texture.wrap[0], TextureWrap::ClampToEdge);
  EXPECT_EQ(material.texture.wrap[1], TextureWrap::MirroredRepeat);
  EXPECT_EQ(material.texture.matrix, (std::array<float, 6>{1, 0, 0, 0, 1, 0}));
  // The other texture is used by no one.
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(texelsOf(scene.textures[0]), kTexels);
  EXPECT_EQ(readRow<2>(scene.parts[0].uvs, 2), (std::array<double, 2>{1, 1}));
}

TEST_F(GltfReader, AlphaModes) {
  EXPECT_EQ(materialOf(loadMaterial("{}"), 0).alpha, AlphaRule::Opaque);
  EXPECT_EQ(materialOf(loadMaterial(R"({"alphaMode":"OPAQUE"})"), 0).alpha, AlphaRule::Opaque);
  const TriangleScene blended = loadMaterial(R"({"alphaMode":"BLEND","alphaCutoff":0.1})");
  EXPECT_EQ(materialOf(blended, 0).alpha, AlphaRule::Blend);
  EXPECT_EQ(materialOf(blended, 0).alphaCutoff, 0.5f);
}

TEST_F(GltfReader, Emission) {
  const std::string textures = R"(,"textures":[{"source":0}],"images":[{"bufferView":4}])";
  TriangleScene scene = loadMaterial(R"({"emissiveFactor":[1,0.5,0.25],
    "emissiveTexture":{"index":0,"texCoord":1,"extensions":{"KHR_texture_transform":{"offset":[0.5,0]}}},
    "pbrMetallicRoughness":{"baseColorFactor":[0,0,0,1]}})",
                                     textures);
  EXPECT_EQ(materialOf(scene, 0).emission, (std::array<float, 3>{1, 0.5f, 0.25f}));
  EXPECT_EQ(materialOf(scene, 0).emissionTexture.texture, 0);
  EXPECT_EQ(materialOf(scene, 0).emissionTexture.matrix[2], 0.5f);
  EXPECT_EQ(materialOf(scene, 0).texture.texture, -1);
  EXPECT_FALSE(scene.parts[0].uvs);
  EXPECT_EQ(readRow<2>(scene.parts[0].emissionUvs, 1), (std::array<double, 2>{0, 1}));
  // Strengths below 1 count; a texture without a factor gives nothing, and a material without light neither.
  scene = loadMaterial(R"({"emissiveFactor":[1,0.5,0.25],
    "extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":0.5}}})");
  EXPECT_EQ(materialOf(scene, 0).emission, (std::array<float, 3>{0.5f, 0.25f, 0.125f}));
  scene = loadMaterial(R"({"emissiveTexture":{"index":0}})", textures);
  EXPECT_EQ(scene.textures.size(), 0u);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(scene.warnings[0],
            "materials[0] has an emissiveTexture and an emissiveFactor of 0, so that it gives off nothing");
  scene = loadMaterial(R"({"emissiveFactor":[1,1,1],"extensions":{"KHR_materials_unlit":{}}})");
  EXPECT_EQ(materialOf(scene, 0).emission, (std::array<float, 3>{}));
}

TEST_F(GltfReader, ATextureWithoutCoordinatesIsLeftOutAloud) {
  const TriangleScene scene =
      loadMaterial(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":7}}})",
                   R"(,"textures":[{"source":0}],"images":[{"bufferView":4}])");
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("has no TEXCOORD_7"), std::string::npos);
  EXPECT_FALSE(scene.parts[0].uvs);
}

TEST_F(GltfReader, TextureTransform) {
  // The extension's own example: a quarter of a turn, into the lower left quadrant.
  const TriangleScene scene =
      loadMaterial(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":3,
    "extensions":{"KHR_texture_transform":{"offset":[0,1],"rotation":1.57079632679,"scale":[0.5,0.5],"texCoord":0}}}}})",
                   R"(,"textures":[{"source":0}],"images":[{"bufferView":4}])");
  const auto &m = materialOf(scene, 0).texture.matrix;
  const std::array<float, 6> expected{0, 0.5f, 0, -0.5f, 0, 1};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(m[i], expected[i], 1e-6);
  EXPECT_TRUE(scene.parts[0].uvs);
}

TEST_F(GltfReader, TheTextureChoosesItsCoordinates) {
  const TriangleScene scene =
      loadMaterial(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":1}}})",
                   R"(,"textures":[{"source":0}],"images":[{"bufferView":4}])");
  EXPECT_EQ(readRow<2>(scene.parts[0].uvs, 1), (std::array<double, 2>{0, 1}));
}

TEST_F(GltfReader, SpecularGlossiness) {
  const TriangleScene scene = loadMaterial(R"({"extensions":{"KHR_materials_pbrSpecularGlossiness":{
    "diffuseFactor":[0,1,0,1],"diffuseTexture":{"index":0}}}})",
                                           R"(,"textures":[{"source":0}],"images":[{"uri":"t.tga"}])");
  EXPECT_EQ(materialOf(scene, 0).colour, (std::array<float, 4>{0, 1, 0, 1}));
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("t.tga"), std::string::npos);
}

} // namespace
} // namespace voxc
