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
}

TEST_F(GltfLeftOut, HiddenNodesAreHiddenWithAllBelow) {
  const TriangleScene scene = model(R"("extensionsUsed":["KHR_node_visibility"],"materials":[{}],
    "nodes":[{"mesh":0,"extensions":{"KHR_node_visibility":{"visible":true}}},
      {"mesh":0,"children":[2],"extensions":{"KHR_node_visibility":{"visible":false}}},{"mesh":0},
      {"mesh":0,"extensions":{"KHR_node_visibility":{}}}])");
  EXPECT_EQ(countTriangles(scene), 2u);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("are left out: 2 nodes")));
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
