// What glTF models have and voxels do not: each is said, hidden nodes are hidden, and files are found beside.
#include "LoadTesting.h"

#include <gmock/gmock.h>

namespace voxc {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class GltfLeftOut : public LoadTest {
protected:
  GltfLeftOut() {
    folder_.file("b.bin", bytesOf({0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f}));
    folder_.file("t.tga", kImage);
  }

  /// A triangle with `attributes` and the material 0, and all else that `rest` has.
  TriangleScene model(const std::string &rest, const std::string &attributes = "",
                      const std::string &buffer = "b.bin") {
    return load("m.gltf", R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":")" + buffer +
                              R"("}],"bufferViews":[{"buffer":0,"byteLength":36}],
      "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
        {"bufferView":0,"componentType":5126,"count":3,"type":"VEC2"}],
      "meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1)" +
                              attributes + R"(},"material":0}]}],)" + rest + "}");
  }
};

const std::string kPlain = R"("materials":[{}],"nodes":[{"mesh":0}])";

TEST_F(GltfLeftOut, NothingOfAModelWithoutMore) { EXPECT_THAT(model(kPlain).warnings, IsEmpty()); }

TEST_F(GltfLeftOut, AllThatHasNoPlaceIsOneSentence) {
  const TriangleScene scene =
      model(R"("extensionsUsed":["KHR_lights_punctual","KHR_materials_ior","KHR_materials_unlit"],
    "cameras":[{}],"nodes":[{"mesh":0}],"textures":[{"source":0}],"images":[{"uri":"t.tga"}],
    "materials":[{"normalTexture":{"index":0},"occlusionTexture":{"index":0}}])",
            R"(,"COLOR_1":0)");
  EXPECT_THAT(scene.warnings,
              ElementsAre("of the model these are not used: COLOR_1, KHR_lights_punctual, KHR_materials_ior, "
                          "cameras, normalTexture, occlusionTexture"));
}

TEST_F(GltfLeftOut, NodesOutsideOfTheSceneAreTold) {
  const TriangleScene scene = model(R"("materials":[{}],"scene":0,"scenes":[{"nodes":[0]},{"nodes":[1]}],
    "nodes":[{"mesh":0},{"mesh":0},{"mesh":0},{}])");
  EXPECT_EQ(countTriangles(scene), 1u);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("scene that is shown are left out: 2 nodes")));
}

TEST_F(GltfLeftOut, ScenesWithoutADefaultAreReadAsOne) {
  const TriangleScene scene = model(R"("materials":[{}],"scenes":[{"nodes":[0]},{"nodes":[1]}],
    "nodes":[{"mesh":0},{"mesh":0}])");
  EXPECT_EQ(countTriangles(scene), 2u);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("it has 2 scenes and does not say which is shown")));
  // What no scene lists is not shown, whether or not one is said; a node may be in several.
  const TriangleScene one =
      model(R"("materials":[{}],"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0},{"mesh":0}])");
  EXPECT_EQ(countTriangles(one), 1u);
  EXPECT_THAT(one.warnings, ElementsAre(HasSubstr("scene that is shown are left out: 1 node")));
  EXPECT_EQ(countTriangles(model(R"("materials":[{}],"scenes":[{"nodes":[0]},{"nodes":[1,0]}],
    "nodes":[{"mesh":0},{"mesh":0}])")),
            2u);
}

TEST_F(GltfLeftOut, HiddenNodesAreHiddenWithAllBelow) {
  const TriangleScene scene = model(R"("extensionsUsed":["KHR_node_visibility"],"materials":[{}],
    "nodes":[{"mesh":0,"extensions":{"KHR_node_visibility":{"visible":true}}},
      {"mesh":0,"children":[2],"extensions":{"KHR_node_visibility":{"visible":false}}},{"mesh":0},
      {"mesh":0,"extensions":{"KHR_node_visibility":{}}}])");
  EXPECT_EQ(countTriangles(scene), 2u);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("are left out: 2 nodes")));
}

TEST_F(GltfLeftOut, AttributesThatAreNotKnownAreTold) {
  EXPECT_THAT(model(kPlain, R"(,"_HEAT":1,"COLOR_2":0,"NORMAL":0,"TEXCOORD_1":1)").warnings,
              ElementsAre("of the model these are not used: COLOR_2, _HEAT"));
}

TEST_F(GltfLeftOut, AttributesOfInstancesAreTold) {
  EXPECT_THAT(model(R"("materials":[{}],"nodes":[{"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":
    {"attributes":{"TRANSLATION":0,"_COLOUR":0}}}}])")
                  .warnings,
              ElementsAre("of the model these are not used: _COLOUR of instances"));
}

TEST_F(GltfLeftOut, AlphaModesThatAreNotKnownAreTold) {
  EXPECT_THAT(model(R"("nodes":[{"mesh":0}],"materials":[{"alphaMode":"OPAQUE"}])").warnings, IsEmpty());
  EXPECT_THAT(model(R"("nodes":[{"mesh":0}],"materials":[{"alphaMode":"HASHED"}])").warnings,
              ElementsAre(HasSubstr("has the alphaMode 'HASHED', which is not known")));
}

TEST_F(GltfLeftOut, LaterVersionsAreRefused) {
  EXPECT_THAT(problem("m.gltf", R"({"asset":{"version":"2.1","minVersion":"2.1"}})"),
              HasSubstr("it needs a reader of glTF 2.1; glTF 2.0 is read"));
}

TEST_F(GltfLeftOut, MeshesThatNoNodeHasAreTold) {
  EXPECT_THAT(load("m.gltf", R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":"b.bin"}],
    "bufferViews":[{"buffer":0,"byteLength":36}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],"nodes":[{"mesh":1}],
    "meshes":[{"primitives":[]},{"primitives":[{"attributes":{"POSITION":0}}]},{"primitives":[]}]})")
                  .warnings,
              ElementsAre("2 meshes are left out, which no node has"));
}

TEST_F(GltfLeftOut, CornersBehindTheLastTriangleAreTold) {
  const auto warningsOf = [&](const std::string &mode, int count) {
    folder_.file("i.bin", bytesOf<std::uint16_t>({0, 1, 2, 0, 2, 1}));
    return load("m.gltf", R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],
    "buffers":[{"byteLength":36,"uri":"b.bin"},{"byteLength":12,"uri":"i.bin"}],
    "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":1,"byteLength":12}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
      {"bufferView":1,"componentType":5123,"count":)" +
                              std::to_string(count) + R"(,"type":"SCALAR"}],
    "meshes":[{"primitives":[{"mode":)" +
                              mode + R"(,"attributes":{"POSITION":0},"indices":1}]}]})")
        .warnings;
  };
  EXPECT_THAT(warningsOf("4", 6), IsEmpty());
  EXPECT_THAT(warningsOf("4", 5), ElementsAre(HasSubstr("5 corners; those behind its last whole triangle")));
  EXPECT_THAT(warningsOf("1", 5), ElementsAre(HasSubstr("5 corners; those behind its last whole line")));
  EXPECT_THAT(warningsOf("5", 5), IsEmpty());
  EXPECT_THAT(warningsOf("1", 2), ElementsAre(HasSubstr("1 vertex is left out")));
}

TEST_F(GltfLeftOut, SkinsOfMeshesThatNameNoJointsAreTold) {
  EXPECT_THAT(
      model(R"("materials":[{}],"skins":[{"joints":[1]}],"nodes":[{"mesh":0,"skin":0},{}])").warnings,
      ElementsAre(
          "meshes[0] has a skin, but no primitive with JOINTS_0 and WEIGHTS_0: the skin moves nothing"));
}

TEST_F(GltfLeftOut, ExtensionsThatAreNotListedCount) {
  EXPECT_THAT(model(R"("nodes":[{"mesh":0,"extensions":{"MINE_nodes":{}},"extras":{"extensions":{"X":{}}}}],
    "materials":[{"extensions":{"KHR_materials_ior":{"ior":1.3},"KHR_materials_unlit":{}}}])")
                  .warnings,
              ElementsAre("the model uses the extension 'MINE_nodes', which is not read",
                          "of the model these are not used: KHR_materials_ior"));
}

TEST_F(GltfLeftOut, ModelsWhoseMeshesAreSeenNowhereAreRefused) {
  const std::string mesh = R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[]}],)";
  EXPECT_THAT(problem("m.gltf", mesh + R"("nodes":[{}]})"),
              HasSubstr("its meshes are placed by no node; give each a node in the scene"));
  EXPECT_THAT(problem("m.gltf", mesh + R"("scene":0,"scenes":[{"nodes":[0]}],"nodes":[{},{"mesh":0}]})"),
              HasSubstr("all its nodes that have a mesh are hidden, or are not reached from"));
}

TEST_F(GltfLeftOut, ColoursAboveOneAreTold) {
  EXPECT_THAT(model(kPlain, R"(,"COLOR_0":0)").warnings, IsEmpty());
  folder_.file("b.bin", bytesOf({0.f, 0.f, 0.f, 255.f, 0.f, 0.f, 1.f, 1.f, 0.f}));
  EXPECT_THAT(model(kPlain, R"(,"COLOR_0":0)").warnings, ElementsAre(HasSubstr("COLOR_0 above 1")));
}

TEST_F(GltfLeftOut, ChunksAndBytesBehindAreTold) {
  std::string json = R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],
    "buffers":[{"byteLength":36,"uri":"b.bin"}],"bufferViews":[{"buffer":0,"byteLength":36}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]})";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto glb = [&](const std::string &chunks, const std::string &behind) {
    const auto size = static_cast<std::uint32_t>(20 + json.size() + chunks.size());
    return load("m.glb", "glTF" + bytesOf<std::uint32_t>({2, size, static_cast<std::uint32_t>(json.size())}) +
                             "JSON" + json + chunks + behind)
        .warnings;
  };
  EXPECT_THAT(glb("", ""), IsEmpty());
  EXPECT_THAT(glb("", "12345"), ElementsAre(HasSubstr("5 bytes are left out")));
  const std::string chunk = bytesOf<std::uint32_t>({4}) + "MINEdata";
  EXPECT_THAT(glb(chunk, ""), ElementsAre(HasSubstr("12 bytes are left out")));
  EXPECT_THAT(glb(bytesOf<std::uint32_t>({4}) + std::string("BIN\0data", 8) + chunk, "1"),
              ElementsAre(HasSubstr("13 bytes are left out")));
}

TEST_F(GltfLeftOut, FilesAreFoundBesideTheModel) {
  const auto textured = [&](const std::string &uri, const std::string &buffer) {
    return model(R"("nodes":[{"mesh":0}],"textures":[{"source":0}],"images":[{"uri":")" + uri +
                     R"("}],"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])",
                 "", buffer);
  };
  EXPECT_THAT(textured("T.TGA", "B.bin").warnings, IsEmpty());
  for (const char *uri : {"textures/t.tga", "https://example.com/a/t.tga", "C:\\\\a\\\\t.tga"}) {
    const TriangleScene scene = textured(uri, "b.bin");
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("beside the model is taken"))) << uri;
    ASSERT_EQ(scene.textures.size(), 1u) << uri;
    EXPECT_EQ(texelsOf(scene.textures[0]), kTexels);
  }
  EXPECT_THAT(textured("none.tga", "b.bin").warnings, ElementsAre(HasSubstr("is left out: cannot read")));
}

} // namespace
} // namespace voxc
