// Meshes through assimp, where the component was built; a clear message where it was not.
#include "Mesh/LoadTesting.h"

#include "voxc/Input/EmissionStrength.h"
#include "voxc/Input/Input.h"

#include <gmock/gmock.h>

#ifdef VOXC_HAS_ASSIMP
#include "Assimp/TrialRead.h"
#include "voxc/Assimp/Assimp.h"

#include <unistd.h>

#include <csignal>
#include <vector>
#endif

namespace voxc {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Assimp, ABuildWithoutItSaysSo) {
  const TemporaryFolder folder;
  for (const char *name : {"a.fbx", "A.DAE", "a.3ds", "a.off", "a.x3d"}) {
    const auto input = openInput(folder.file(name, ""), {});
    ASSERT_FALSE(input);
    EXPECT_EQ(input.error().kind, ErrorKind::Environment);
    EXPECT_THAT(input.error().message, HasSubstr("VOXC_ASSIMP=ON"));
  }
}

#ifdef VOXC_HAS_ASSIMP

class AssimpMeshes : public testing::Test {
protected:
  Input open(const std::string &name, const std::string &content) {
    options_.otherKinds = assimpKinds();
    options_.resolution = 2;
    auto input = openInput(folder_.file(name, content), options_);
    EXPECT_TRUE(input) << input.error().message;
    return input ? std::move(*input) : Input{};
  }
  std::string problem(const std::string &name, const std::string &content) {
    options_.otherKinds = assimpKinds();
    auto input = openInput(folder_.file(name, content), options_);
    return input ? "no error" : input.error().message;
  }

  TemporaryFolder folder_;
  InputOptions options_;
};

/// A square in the plane z = 0 with the material of this effect, twice as wide as high by its node.
std::string collada(const std::string &effect, const std::string &images = "", const std::string &more = "") {
  return "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
         "version=\"1.4.1\">"
         "<asset><up_axis>Y_UP</up_axis></asset>" +
         images + "<library_effects><effect id=\"e\"><profile_COMMON>" + effect +
         "</profile_COMMON></effect></library_effects>"
         "<library_materials><material id=\"m\"><instance_effect url=\"#e\"/></material></library_materials>"
         "<library_geometries><geometry id=\"g\"><mesh>"
         "<source id=\"p\"><float_array id=\"pa\" count=\"12\">0 0 0 1 0 0 1 1 0 0 1 0</float_array>"
         "<technique_common><accessor source=\"#pa\" count=\"4\" stride=\"3\"><param name=\"X\" "
         "type=\"float\"/>"
         "<param name=\"Y\" type=\"float\"/><param name=\"Z\" "
         "type=\"float\"/></accessor></technique_common></source>"
         "<source id=\"t\"><float_array id=\"ta\" count=\"8\">0 0 1 0 1 1 0 1</float_array>"
         "<technique_common><accessor source=\"#ta\" count=\"4\" stride=\"2\"><param name=\"S\" "
         "type=\"float\"/>"
         "<param name=\"T\" type=\"float\"/></accessor></technique_common></source>"
         "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>"
         "<polylist material=\"s\" count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
         "<input semantic=\"TEXCOORD\" source=\"#t\" offset=\"1\" set=\"0\"/>"
         "<vcount>4</vcount><p>0 0 1 1 2 2 3 3</p></polylist></mesh></geometry></library_geometries>"
         "<library_visual_scenes><visual_scene id=\"sc\"><node id=\"n\"><scale>2 1 1</scale>"
         "<instance_geometry url=\"#g\"><bind_material><technique_common><instance_material symbol=\"s\" "
         "target=\"#m\">"
         "<bind_vertex_input semantic=\"UV0\" input_semantic=\"TEXCOORD\" "
         "input_set=\"0\"/></instance_material>"
         "</technique_common></bind_material></instance_geometry></node>" +
         more +
         "</visual_scene></library_visual_scenes><scene><instance_visual_scene "
         "url=\"#sc\"/></scene></COLLADA>";
}

TEST_F(AssimpMeshes, ColladaColours) {
  const Input input =
      open("m.dae", collada("<technique sid=\"c\"><lambert><diffuse><color>1 0.2 0 1</color></diffuse>"
                            "</lambert></technique>"));
  EXPECT_EQ(input.source->extent(), (Int3{2, 1, 1}));
  EXPECT_EQ(voxelsOf(*input.source),
            (Voxels{{mortonCode({0, 0, 0}), rgba(255, 51, 0)}, {mortonCode({1, 0, 0}), rgba(255, 51, 0)}}));
  EXPECT_EQ(input.triangles, 2u);
  EXPECT_THAT(input.warnings, IsEmpty());
}

TEST_F(AssimpMeshes, ColladaTextures) {
  // The left texel is red, the right green.
  folder_.file("t.tga", std::string("\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\30\40\0\0\377\0\377\0", 24));
  const std::string effect =
      "<newparam sid=\"su\"><surface type=\"2D\"><init_from>i</init_from></surface></newparam><newparam "
      "sid=\"sa\">"
      "<sampler2D><source>su</source></sampler2D></newparam><technique sid=\"c\"><lambert><diffuse>"
      "<texture texture=\"sa\" texcoord=\"UV0\"/></diffuse></lambert></technique>";
  for (const char *path : {"t.tga", "C:/elsewhere/t.tga"}) {
    const Input input =
        open("m.dae", collada(effect, "<library_images><image id=\"i\"><init_from>" + std::string(path) +
                                          "</init_from></image></library_images>"));
    EXPECT_EQ(voxelsOf(*input.source),
              (Voxels{{mortonCode({0, 0, 0}), rgba(255, 0, 0)}, {mortonCode({1, 0, 0}), rgba(0, 255, 0)}}));
    EXPECT_EQ(input.warnings.size(), path[0] == 't' ? 0u : 1u);
  }
}

TEST_F(AssimpMeshes, WhatMaterialsGiveOffIsAddedAndKept) {
  const auto effect = [](const std::string &emission) {
    return "<technique sid=\"c\"><phong><emission><color>" + emission +
           "</color></emission><diffuse><color>0.2 0.2 0 1</color></diffuse></phong></technique>";
  };
  const auto words = [&](MaterialWords what, const std::string &emission) {
    options_.materialWords = what;
    const Input input = open("m.dae", collada(effect(emission)));
    EXPECT_THAT(input.warnings, IsEmpty());
    const Voxels voxels = voxelsOf(*input.source);
    return voxels.empty() ? 0 : voxels.begin()->second;
  };
  EXPECT_EQ(words(MaterialWords::Colours, "0.4 0 1 1"), rgba(153, 51, 255));
  EXPECT_EQ(words(MaterialWords::Emission, "0.4 0 1 1"), rgba(102, 0, 255));
  EXPECT_EQ(words(MaterialWords::Colours, "0 0 0 1"), rgba(51, 51, 0));
  // Light above 1 keeps its hue, and numbers below 0 are none.
  EXPECT_EQ(words(MaterialWords::Emission, "2 -3 4 1"), rgba(128, 0, 255));
}

TEST_F(AssimpMeshes, TexturesOfEmissionAreTakenByThemselves) {
  folder_.file("t.tga", std::string("\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\30\40\0\0\377\0\377\0", 24));
  const Input input =
      open("m.dae", collada("<newparam sid=\"su\"><surface type=\"2D\"><init_from>i</init_from></surface>"
                            "</newparam><newparam sid=\"sa\"><sampler2D><source>su</source></sampler2D>"
                            "</newparam><technique sid=\"c\"><phong><emission><texture texture=\"sa\" "
                            "texcoord=\"UV0\"/></emission><diffuse><color>0 0 0.2 1</color></diffuse>"
                            "</phong></technique>",
                            "<library_images><image id=\"i\"><init_from>t.tga</init_from></image>"
                            "</library_images>"));
  EXPECT_EQ(voxelsOf(*input.source),
            (Voxels{{mortonCode({0, 0, 0}), rgba(255, 0, 51)}, {mortonCode({1, 0, 0}), rgba(0, 255, 51)}}));
  EXPECT_THAT(input.warnings, IsEmpty());
}

/// A triangle whose material has these properties.
std::string fbx(const std::string &properties) {
  return "; FBX 7.4.0 project file\n"
         "FBXHeaderExtension: {\n FBXHeaderVersion: 1003\n FBXVersion: 7400\n}\n"
         "GlobalSettings: {\n Version: 1000\n}\n"
         "Objects: {\n"
         " Geometry: 1, \"Geometry::g\", \"Mesh\" {\n"
         "  Vertices: *9 {\n   a: 0,0,0,2,0,0,2,2,0\n  }\n"
         "  PolygonVertexIndex: *3 {\n   a: 0,1,-3\n  }\n"
         "  LayerElementMaterial: 0 {\n   MappingInformationType: \"AllSame\"\n"
         "   ReferenceInformationType: \"IndexToDirect\"\n   Materials: *1 {\n    a: 0\n   }\n  }\n"
         "  Layer: 0 {\n   LayerElement: {\n    Type: \"LayerElementMaterial\"\n    TypedIndex: 0\n   }\n  "
         "}\n"
         " }\n"
         " Model: 2, \"Model::m\", \"Mesh\" {\n  Version: 232\n }\n"
         " Material: 3, \"Material::x\", \"\" {\n  Version: 102\n  ShadingModel: \"unknown\"\n"
         "  Properties70: {\n" +
         properties +
         "  }\n }\n}\n"
         "Connections: {\n C: \"OO\",2,0\n C: \"OO\",1,2\n C: \"OO\",3,2\n}\n";
}

TEST_F(AssimpMeshes, MetalAndRoughnessAreKept) {
  const auto words = [&](MaterialWords what, const std::string &properties) {
    options_.materialWords = what;
    const Input input = open("m.fbx", fbx(properties));
    const Voxels voxels = voxelsOf(*input.source);
    return voxels.empty() ? 0 : voxels.begin()->second;
  };
  const std::string metal = "   P: \"Maya|metallic\", \"float\", \"\", \"A\",0.4\n";
  const std::string rough = "   P: \"Maya|roughness\", \"float\", \"\", \"A\",0.2\n";
  const std::string light = "   P: \"EmissiveColor\", \"Color\", \"\", \"A\",1,0.5,0\n";
  const std::string half = "   P: \"EmissiveFactor\", \"Number\", \"\", \"A\",0.4\n";
  const std::string maya = "   P: \"Maya|emissive\", \"Vector3D\", \"Vector\", \"A\",1,0,1\n";
  const std::string base = "   P: \"Maya|base_color\", \"Vector3D\", \"Vector\", \"A\",0,0.2,1\n";
  EXPECT_EQ(words(MaterialWords::MetallicRoughness, metal + rough), rgba(0, 51, 102));
  EXPECT_EQ(words(MaterialWords::MetallicRoughness, metal), rgba(0, 255, 102));
  EXPECT_EQ(words(MaterialWords::Emission, light + half), rgba(102, 51, 0));
  EXPECT_EQ(words(MaterialWords::Emission,
                  maya + "   P: \"Maya|emissive_intensity\", \"float\", \"\", \"A\",0.2\n"),
            rgba(51, 0, 51));
  EXPECT_EQ(strengthOfWord(words(MaterialWords::EmissionStrength,
                                 maya + "   P: \"Maya|emissive_intensity\", \"float\", \"\", \"A\",8\n")),
            8);
  EXPECT_EQ(words(MaterialWords::Colours, base), rgba(0, 51, 255));
}

/// In a format that states fractions, one corner that is too bright does not darken the others.
TEST_F(AssimpMeshes, ColladaColoursOfVertices) {
  std::string file = collada(
      "<technique sid=\"c\"><lambert><diffuse><color>1 1 1 1</color></diffuse></lambert></technique>");
  const auto insert = [&](const std::string &before, const std::string &text) {
    file.insert(file.find(before), text);
  };
  insert("<vertices", "<source id=\"c\"><float_array id=\"ca\" count=\"12\">2.5 0.2 0 1 0.2 0 1 0.2 0 1 0.2 0"
                      "</float_array><technique_common><accessor source=\"#ca\" count=\"4\" stride=\"3\">"
                      "<param name=\"R\" type=\"float\"/><param name=\"G\" type=\"float\"/>"
                      "<param name=\"B\" type=\"float\"/></accessor></technique_common></source>");
  insert("<vcount>", "<input semantic=\"COLOR\" source=\"#c\" offset=\"0\"/>");
  const Input input = open("m.dae", file);
  const Voxels voxels = voxelsOf(*input.source);
  EXPECT_EQ(voxels.size(), 2u);
  for (const auto &[code, word] : voxels)
    EXPECT_EQ(word & 0xff00u, rgba(0, 51, 0) & 0xff00u);
}

TEST_F(AssimpMeshes, OffFiles) {
  const Input input = open("m.off", "OFF\n4 1 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n4 0 1 2 3\n");
  EXPECT_EQ(voxelsOf(*input.source).size(), 4u);
  EXPECT_EQ(input.triangles, 2u);
}

TEST_F(AssimpMeshes, ColoursThatCountTo255AreTakenSo) {
  for (const char *const colour : {"255 128 0 255", "1 0.502 0 1", "255 128 0 1"}) {
    std::string file = "COFF\n4 1 0\n";
    for (const char *const corner : {"0 0 0 ", "2 0 0 ", "2 2 0 ", "0 2 0 "})
      file += std::string(corner) + colour + "\n";
    const Input input = open("m.off", file + "4 0 1 2 3\n");
    const Voxels voxels = voxelsOf(*input.source);
    EXPECT_EQ(voxels.size(), 4u);
    for (const auto &[code, word] : voxels)
      EXPECT_EQ(word, rgba(255, 128, 0)) << colour;
    if (colour[0] == '1')
      EXPECT_THAT(input.warnings, IsEmpty());
    else
      EXPECT_THAT(input.warnings, ElementsAre(HasSubstr("numbers that count to 255")));
  }
}

TEST_F(AssimpMeshes, ColoursOfFacesAreSaidToBeLeftOut) {
  const std::string vertices = "# a square\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n";
  EXPECT_THAT(open("m.off", "OFF\n4 1 0\n" + vertices + "4 0 1 2 3 255 0 0\n").warnings,
              ElementsAre(HasSubstr("colours of faces are not read")));
  EXPECT_THAT(open("m.off", "OFF 4 1 0\n" + vertices + "4 0 1 2 3 # 255 0 0\n").warnings, IsEmpty());
}

/// A triangle that is four high along z and two wide along x.
TEST_F(AssimpMeshes, TheUpOfAnFbxFileIsTurnedToY) {
  const auto extentWith = [&](const std::string &settings) {
    std::string file = fbx("");
    file.replace(file.find("2,2,0"), 5, "2,0,4");
    const std::string version = "GlobalSettings: {\n Version: 1000\n";
    file.insert(file.find(version) + version.size(), " Properties70: {\n" + settings + " }\n");
    return open("m.fbx", file).source->extent();
  };
  EXPECT_EQ(extentWith("  P: \"UpAxis\", \"int\", \"Integer\", \"\",1\n"), (Int3{1, 1, 2}));
  EXPECT_EQ(extentWith("  P: \"UpAxis\", \"int\", \"Integer\", \"\",2\n"), (Int3{1, 2, 1}));
}

/// A chunk of a .3ds.
std::string chunk(std::uint16_t id, const std::string &content) {
  return bytesOf({id}) + bytesOf({static_cast<std::uint32_t>(content.size() + 6)}) + content;
}

TEST_F(AssimpMeshes, ThreeDsFiles) {
  const std::string colour = chunk(0x0011, std::string("\0\377\0", 3));
  const std::string material = chunk(0xafff, chunk(0xa000, std::string("m\0", 2)) + chunk(0xa020, colour));
  const std::string vertices =
      bytesOf<std::uint16_t>({3}) + bytesOf({0.f, 0.f, 0.f, 2.f, 0.f, 0.f, 2.f, 0.f, 2.f});
  const std::string faces = bytesOf<std::uint16_t>({1, 0, 1, 2, 0}) +
                            chunk(0x4130, std::string("m\0", 2) + bytesOf<std::uint16_t>({1, 0}));
  const std::string mesh = chunk(0x4100, chunk(0x4110, vertices) + chunk(0x4120, faces));
  const Input input =
      open("m.3ds", chunk(0x4d4d, chunk(0x3d3d, material + chunk(0x4000, std::string("o\0", 2) + mesh))));
  const Voxels voxels = voxelsOf(*input.source);
  ASSERT_FALSE(voxels.empty());
  for (const auto &[code, word] : voxels)
    EXPECT_EQ(word, rgba(0, 255, 0));
}

TEST_F(AssimpMeshes, BrokenFilesAreErrors) {
  EXPECT_THAT(problem("m.off", "OFF\n4 1\n"), HasSubstr("m.off'"));
  EXPECT_THAT(problem("m.fbx", "not an fbx"), HasSubstr("cannot be read through assimp"));
  EXPECT_THAT(problem("m.dae", "<COLLADA"), HasSubstr("cannot be read through assimp"));
  EXPECT_THAT(problem("m.off", "OFF\n3 1 0\n0 0 0\nnan 0 0\n0 1 0\n3 0 1 2\n"), HasSubstr("m.off'"));
}

TEST(TrialRead, WhatCrashesIsAnError) {
  const auto problem = [](const std::function<std::string()> &read) {
    const auto tried = tryToRead(read, std::uint64_t{1} << 26, {});
    return tried ? std::string("no error") : tried.error().message;
  };
  EXPECT_EQ(problem([] { return std::string(); }), "no error");
  EXPECT_EQ(problem([] { return std::string("it is red"); }), "it is red");
  EXPECT_THAT(problem([]() -> std::string {
                std::raise(SIGSEGV);
                return {};
              }),
              HasSubstr("the file is broken"));
  EXPECT_THAT(problem([] { return std::string(std::vector<char>(std::size_t{1} << 32, 'x').data(), 3); }),
              HasSubstr("more memory"));
}

TEST(TrialRead, CrashesAreSeenInProgramsThatIgnoreTheirChildren) {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  EXPECT_TRUE(tryToRead([] { return std::string(); }, std::uint64_t{1} << 26, {}));
  EXPECT_FALSE(tryToRead([]() -> std::string { std::abort(); }, std::uint64_t{1} << 26, {}));
  std::signal(SIGCHLD, before);
}

TEST(TrialRead, StopsWhenAsked) {
  const std::atomic<bool> stop = true;
  Progress progress;
  progress.stop = &stop;
  const auto tried = tryToRead(
      []() -> std::string {
        for (;;)
          pause();
      },
      1, progress);
  ASSERT_FALSE(tried);
  EXPECT_EQ(tried.error().kind, ErrorKind::Interrupted);
}

#endif

} // namespace
} // namespace voxc
