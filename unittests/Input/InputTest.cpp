// Opening inputs: kinds, sizes that do not fit, grids from files, and the provenance.
#include "Source/SourceTesting.h"

#include "voxc/Input/Input.h"

namespace voxc {
namespace {

class InputTest : public testing::Test {
protected:
  std::string problem(const std::string &input) {
    auto opened = openInput(input, options_);
    return opened ? "no error" : opened.error().message;
  }

  TemporaryFolder folder_;
  InputOptions options_;
};

TEST_F(InputTest, UnknownKindNamesTheKnownOnes) {
  EXPECT_NE(problem("scene.fbx").find(".glb"), std::string::npos);
  EXPECT_NE(problem("scene").find("builtin:"), std::string::npos);
  EXPECT_NE(problem("").find("builtin:"), std::string::npos);
}

TEST_F(InputTest, KindsThatAreNotReadAreRefusedWithAdvice) {
  for (const auto &[name, advice] :
       {std::pair{"a.obj.gz", "packed by gzip, which voxc does not read; unpack it"},
        std::pair{"Scan.PCD", "save it as .ply, for example by CloudCompare"},
        std::pair{"a/b.usdz", "a scene of USD"}, std::pair{"slice%03d.jpg", "save it as .png or .tif"},
        std::pair{"part.step", "for example by FreeCAD"}})
    EXPECT_NE(problem(name).find(advice), std::string::npos) << problem(name);
}

TEST_F(InputTest, MissingFilesAreErrorsOfTheInput) {
  for (const char *name : {"a.obj", "a.glb", "a.gltf", "a.stl", "a.ply", "a.hvx"}) {
    auto input = openInput(folder_.path(name), options_);
    ASSERT_FALSE(input) << name;
    EXPECT_EQ(input.error().kind, ErrorKind::Input);
    EXPECT_NE(input.error().message.find(name), std::string::npos);
  }
}

TEST_F(InputTest, GridTakesExactlyItsBytes) {
  const std::string path = folder_.file("g.raw", std::string("\1\0\0\0\0\0\0\0\0\0\0\0\2\0\0\xff", 16));
  auto input = openInput("grid:2x1x2:" + path, options_);
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(input->provenance, "grid=2x1x2");
  EXPECT_EQ(voxelsOf(*input->source),
            (Voxels{{mortonCode({0, 0, 0}), 1}, {mortonCode({1, 0, 1}), 0xff000002}}));

  EXPECT_NE(problem("grid:2x2x2:" + path).find("16 bytes"), std::string::npos);
  EXPECT_NE(problem("grid:2097152x2097152x2097152:" + path).find("16 bytes"), std::string::npos);
  for (const char *size : {"0x1x2", "2x2", "2x1x2x1", "-2x1x2", "2x1x9999999999", "", "axbxc", "2097153x1x1"})
    EXPECT_NE(problem("grid:" + std::string(size) + ":" + path), "no error") << size;
  EXPECT_NE(problem("grid:2x1x2"), "no error");
}

TEST_F(InputTest, BuiltinTakesItsSizeFromTheInputThenTheOptionsThenTheFormat) {
  options_.formatExtent = {16, 8, 4};
  const auto extent = [&](const std::string &text) {
    auto input = openInput(text, options_);
    EXPECT_TRUE(input) << input.error().message;
    return input ? input->source->extent() : Int3{};
  };
  EXPECT_EQ(extent("builtin:full:4"), (Int3{4, 4, 4}));
  EXPECT_EQ(extent("builtin:full"), (Int3{16, 8, 4}));
  options_.resolution = 3;
  EXPECT_EQ(extent("builtin:full"), (Int3{3, 3, 3}));
  EXPECT_EQ(extent("builtin:full:4"), (Int3{4, 4, 4}));
  EXPECT_NE(problem("builtin:full:5").find("16x8x4"), std::string::npos);
  for (const char *text : {"builtin:", "builtin:no", "builtin:full:", "builtin:full:x", "builtin:full:0"})
    EXPECT_NE(problem(text), "no error") << text;
}

TEST_F(InputTest, ClippedSceneHasNothingOutsideTheFormat) {
  options_.formatExtent = {16, 2, 4};
  auto input = openInput("builtin:full", options_);
  ASSERT_TRUE(input);
  EXPECT_EQ(voxelsOf(*input->source).size(), 16u * 2 * 4);
}

TEST_F(InputTest, MeshFillsTheFormatUnlessToldOtherwise) {
  const std::string path = folder_.file("m.obj", "v 0 0 0\nv 4 0 0\nv 0 2 0\nv 4 2 1\nf 1 2 3\nf 2 4 3\n");
  options_.formatExtent = {64, 16, 64};
  auto input = openInput(path, options_);
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(input->source->extent(), (Int3{32, 16, 8}));
  EXPECT_EQ(input->triangles, 2u);
  EXPECT_EQ(input->provenance, "resolution=32 coverage=conservative up=y");

  options_.resolution = 64;
  const std::string text = problem(path);
  EXPECT_NE(text.find("64x32x16"), std::string::npos);
  EXPECT_NE(text.find("64x16x64"), std::string::npos);

  options_.resolution = 8;
  options_.bounds = {{0, 0, 0, 2, 0.1, 1}};
  input = openInput(path, options_);
  ASSERT_TRUE(input);
  EXPECT_EQ(input->provenance, "resolution=8 coverage=conservative bounds=0,0,0,2,0.1,1 up=y");
}

} // namespace
} // namespace voxc
