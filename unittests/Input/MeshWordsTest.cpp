// What else the materials of a mesh say at its voxels: emission, metal and roughness.
#include "Source/SourceTesting.h"

#include "voxc/Input/EmissionStrength.h"
#include "voxc/Input/Input.h"

#include <gmock/gmock.h>

namespace voxc {
namespace {

/// Two texels from the left as an uncompressed TGA, each blue, green, red, alpha.
std::string image(const std::string &texels) {
  return std::string("\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\40\50", 18) + texels;
}

class MeshWordsTest : public testing::Test {
protected:
  /// A square of 1, whose texture coordinates go from (0, 0) to (1, 1), of one material.
  std::string model(const std::string &material, const std::string &rest = "") {
    const std::vector<float> numbers{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 1};
    std::string buffer(reinterpret_cast<const char *>(numbers.data()), numbers.size() * sizeof(float));
    buffer += std::string("\0\1\2\0\2\3\0\0", 8);
    folder_.file("b.bin", buffer);
    return folder_.file("m.gltf", R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[
      {"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":0}]}],
      "accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
        {"bufferView":0,"byteOffset":48,"componentType":5126,"count":4,"type":"VEC2"},
        {"bufferView":1,"componentType":5121,"count":6,"type":"SCALAR"}],
      "bufferViews":[{"buffer":0,"byteLength":80},{"buffer":0,"byteOffset":80,"byteLength":8}],
      "buffers":[{"uri":"b.bin","byteLength":88}],"materials":[)" +
                                      material + "]" + rest + "}");
  }

  Voxels words(const std::string &path, MaterialWords words) {
    InputOptions options;
    options.resolution = 4;
    options.materialWords = words;
    auto input = openInput(path, options);
    EXPECT_TRUE(input) << input.error().message;
    return input ? voxelsOf(*input->source) : Voxels();
  }

  TemporaryFolder folder_;
};

TEST_F(MeshWordsTest, EmissionWithoutTheColour) {
  const std::string path =
      model(R"({"emissiveFactor":[1,0.5,0],"pbrMetallicRoughness":{"baseColorFactor":[0,0,1,1]}})");
  const Voxels colours = words(path, MaterialWords::Colours);
  EXPECT_EQ(colours.size(), 16u);
  for (const auto &[code, word] : colours)
    EXPECT_EQ(word, rgba(255, 188, 255));
  for (const auto &[code, word] : words(path, MaterialWords::Emission))
    EXPECT_EQ(word, rgba(255, 188, 0));
}

TEST_F(MeshWordsTest, MetalAndRoughnessAsTheirTextureHasThem) {
  folder_.file("t.tga", image(std::string("\200\100\0\377\0\300\0\377", 8)));
  const std::string path = model(R"({"pbrMetallicRoughness":{"roughnessFactor":0.5,
    "metallicRoughnessTexture":{"index":0}}})",
                                 R"(,"textures":[{"source":0}],"images":[{"uri":"t.tga"}])");
  for (const auto &[code, word] : words(path, MaterialWords::MetallicRoughness))
    EXPECT_EQ(word, mortonCell(code).x < 2 ? rgba(0, 32, 128) : rgba(0, 96, 0));
  // Colours need no such texture, and do not miss it.
  for (const auto &[code, word] : words(path, MaterialWords::Colours))
    EXPECT_EQ(word, rgba(255, 255, 255));
}

TEST_F(MeshWordsTest, AlphaCutsOutAsItDoesInColour) {
  folder_.file("t.tga", image(std::string("\0\0\377\377\0\0\377\0", 8)));
  const std::string path = model(R"({"alphaMode":"MASK","emissiveFactor":[0,1,0],
    "pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":0}}})",
                                 R"(,"textures":[{"source":0}],"images":[{"uri":"t.tga"}])");
  const Voxels emission = words(path, MaterialWords::Emission);
  const Voxels metal = words(path, MaterialWords::MetallicRoughness);
  ASSERT_EQ(emission.size(), 8u);
  ASSERT_EQ(metal.size(), 8u);
  for (const auto &[code, word] : emission) {
    EXPECT_LT(mortonCell(code).x, 2);
    EXPECT_EQ(word, rgba(0, 255, 0));
    EXPECT_EQ(metal.at(code), rgba(0, 255, 0));
  }
}

TEST_F(MeshWordsTest, AModelWithoutThemSaysSo) {
  InputOptions options;
  options.materialWords = MaterialWords::Emission;
  auto input = openInput(model("{}"), options);
  ASSERT_FALSE(input);
  EXPECT_NE(input.error().message.find("gives off light"), std::string::npos);
  options.materialWords = MaterialWords::MetallicRoughness;
  input = openInput(model("{}"), options);
  ASSERT_FALSE(input);
  EXPECT_NE(input.error().message.find("how metallic or rough"), std::string::npos);
  // Other kinds have no materials at all.
  input = openInput("builtin:full:4", options);
  ASSERT_FALSE(input);
  EXPECT_NE(input.error().message.find("says nothing of light and metal"), std::string::npos);
}

TEST_F(MeshWordsTest, LightAndMetalOfAnObj) {
  folder_.file("t.tga", image(std::string("\377\377\0\377\0\0\0\377", 8)));
  folder_.file("m.mtl", "newmtl lamp\nKd 0.2 0 0\nKe 8 4 0\nnewmtl pane\nKd 0 0 0\nKe 0 0 0\nmap_Ke t.tga\n"
                        "newmtl steel\nPm 0.6\nPr 0.2\nnewmtl plain\nKe 0 0 0\n");
  const auto model = [&](const std::string &material) {
    return folder_.file("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
                                 "vt 0 1\nusemtl " +
                                     material + "\nf 1/1 2/2 3/3 4/4\n");
  };
  const std::string lamp = model("lamp");
  for (const auto &[code, word] : words(lamp, MaterialWords::Colours))
    EXPECT_EQ(word, rgba(255, 128, 0));
  for (const auto &[code, word] : words(lamp, MaterialWords::Emission))
    EXPECT_EQ(word, rgba(255, 128, 0));
  for (const auto &[code, word] : words(lamp, MaterialWords::EmissionStrength))
    EXPECT_EQ(strengthOfWord(word), 8);
  const std::string pane = model("pane");
  for (const auto what : {MaterialWords::Colours, MaterialWords::Emission})
    for (const auto &[code, word] : words(pane, what))
      EXPECT_EQ(word, mortonCell(code).x < 2 ? rgba(0, 255, 255) : rgba(0, 0, 0));
  const std::string steel = model("steel");
  for (const auto &[code, word] : words(steel, MaterialWords::MetallicRoughness))
    EXPECT_EQ(word, rgba(0, 51, 153));
  for (const auto &[code, word] : words(steel, MaterialWords::Colours))
    EXPECT_EQ(word, rgba(255, 255, 255));
  InputOptions options;
  options.resolution = 4;
  EXPECT_THAT(
      openInput(model("pane"), options)->warnings,
      testing::ElementsAre("the material 'pane' has the Ke 0 beside a texture of what it gives off, which "
                           "is taken as it is"));
  options.materialWords = MaterialWords::Emission;
  EXPECT_FALSE(openInput(model("plain"), options));
}

TEST_F(MeshWordsTest, StrengthsOfLight) {
  const std::string path = model(R"({"emissiveFactor":[1,0.5,0],"emissiveTexture":{"index":0},
    "extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":12.5}}})",
                                 R"(,"textures":[{"source":0}],"images":[{"uri":"t.tga"}])");
  folder_.file("t.tga", image(std::string("\377\377\377\377\0\0\0\377", 8)));
  for (const auto &[code, word] : words(path, MaterialWords::EmissionStrength))
    EXPECT_EQ(strengthOfWord(word), 12.5F);
  for (const auto &[code, word] : words(path, MaterialWords::Emission))
    EXPECT_EQ(word, mortonCell(code).x < 2 ? rgba(255, 188, 0) : rgba(0, 0, 0));
  // Numbers that take all bits come back as they went.
  for (const float strength : {0.F, 0.1F, 1.F, 3.3333333F, 1e9F}) {
    const float kept = strengthOfWord(strengthWord(strength));
    EXPECT_NEAR(kept, strength, strength / 65536);
    EXPECT_EQ(strengthOfWord(strengthWord(kept)), kept);
  }
}

} // namespace
} // namespace voxc
