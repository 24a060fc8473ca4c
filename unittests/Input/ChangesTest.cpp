// Inputs whose inside is changed, and which are cropped: what is told of it, and what fits.
#include "Source/SourceTesting.h"
#include "VoxBytes.h"

#include "voxc/Input/Input.h"
#include "voxc/Source/Sources.h"

namespace voxc {
namespace {

class ChangesTest : public testing::Test {
protected:
  Input open(const std::string &name) {
    auto input = openInput(name, options_);
    EXPECT_TRUE(input) << input.error().message;
    return input ? std::move(*input) : Input{};
  }
  std::string problem(const std::string &name) {
    auto input = openInput(name, options_);
    return input ? "no error" : input.error().message;
  }

  /// Points at the corners of a box.
  std::string points(Int3 low, Int3 high, const std::string &type) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex 8\nproperty " + type + " x\nproperty " + type +
                       " y\nproperty " + type + " z\nend_header\n";
    for (int corner = 0; corner < 8; ++corner)
      for (int axis = 0; axis < 3; ++axis)
        text += std::to_string((corner >> axis & 1) != 0 ? high[axis] : low[axis]) + (axis < 2 ? " " : "\n");
    return folder_.file("points.ply", text);
  }

  TemporaryFolder folder_;
  InputOptions options_;
};

TEST_F(ChangesTest, WhatIsCroppedMayBeLargerThanTheFormat) {
  options_.formatExtent = {16, 16, 16};
  const std::string far = points({1000, 2000, 3000}, {1015, 2001, 3009}, "int");
  EXPECT_NE(problem(far).find("holds only 16x16x16"), std::string::npos);
  options_.crop = true;
  const Input input = open(far);
  EXPECT_EQ(input.source->extent(), (Int3{16, 2, 10}));
  EXPECT_TRUE(input.isCropped);
  EXPECT_EQ(input.cropLow, (Int3{1000, 2000, 3000}));
  EXPECT_EQ(input.provenance, "coverage=indices crop=1000,2000,3000");
  EXPECT_EQ(input.notes.size(), 1u);
  EXPECT_NE(problem(points({0, 0, 0}, {16, 0, 0}, "int")).find("takes 17x1x1 voxels"), std::string::npos);
}

TEST_F(ChangesTest, ModelsGetTheirResolutionBeforeTheyAreCropped) {
  options_.formatExtent = {16, 16, 16};
  options_.crop = true;
  // Bounds of 40 around points in a box of 10.
  options_.bounds = {{0, 0, 0, 40, 40, 40}};
  const std::string few = points({20, 20, 20}, {30, 30, 30}, "float");
  EXPECT_EQ(open(few).source->extent(), (Int3{5, 5, 5}));
  options_.resolution = 40;
  EXPECT_EQ(open(few).source->extent(), (Int3{11, 11, 11}));
  options_.resolution = 80;
  EXPECT_NE(problem(few).find("takes 21x21x21 voxels"), std::string::npos);
}

TEST_F(ChangesTest, AnInputWithoutABorderStaysAsItIs) {
  options_.crop = true;
  const Input input = open("builtin:shell:20");
  EXPECT_EQ(input.provenance, "builtin=shell:20");
  EXPECT_TRUE(input.notes.empty());
  EXPECT_TRUE(input.isCropped);
  EXPECT_EQ(input.cropLow, Int3{});
}

/// A model of 5 voxels a side, with colour 1, in whose middle a cell is empty.
std::string hollowModel() {
  std::string voxels;
  for (std::uint32_t i = 0; i < 125; ++i)
    if (i != 62)
      voxels += wordBytes({i % 5 | i / 5 % 5 << 8 | i / 25 << 16 | 1u << 24});
  return voxBytes(chunkBytes("SIZE", wordBytes({9, 9, 9})) + chunkBytes("XYZI", wordBytes({124}) + voxels));
}

TEST_F(ChangesTest, TheInsideIsToldInTheProvenance) {
  const std::string model = folder_.file("hollow.vox", hollowModel());
  options_.interior = Interior::Drop;
  const Input dropped = open(model);
  EXPECT_EQ(dropped.interior, Interior::Drop);
  EXPECT_EQ(dropped.interiorVoxels, 26u);
  EXPECT_EQ(voxelsOf(*dropped.source).size(), 98u);
  EXPECT_EQ(dropped.provenance, "coverage=models interior=drop");
  options_.interior = Interior::Fill;
  options_.fillWord = 0x80332211;
  options_.crop = true;
  const Input filled = open(model);
  EXPECT_EQ(filled.interiorVoxels, 1u);
  EXPECT_EQ(filled.source->extent(), (Int3{5, 5, 5}));
  EXPECT_EQ(voxelsOf(*filled.source).at(mortonCode({2, 2, 2})), 0x80332211u);
  EXPECT_EQ(filled.provenance, "coverage=models interior=fill fill-colour=11223380 crop=0,0,4");
}

TEST_F(ChangesTest, TheInsideOfLabelsIsALabel) {
  std::string cells(216, '\0');
  for (int z = 1; z < 5; ++z)
    for (int y = 1; y < 5; ++y)
      for (int x = 1; x < 5; ++x)
        cells[static_cast<std::size_t>((z * 6 + y) * 6 + x)] = 3;
  cells[static_cast<std::size_t>((2 * 6 + 2) * 6 + 2)] = 0;
  const std::string input = "raw:6x6x6:uint8:" + folder_.file("labels.raw", cells);
  options_.colourMap = "labels";
  options_.interior = Interior::Fill;
  const auto white = openInput(input, options_);
  ASSERT_FALSE(white);
  EXPECT_NE(white.error().message.find("--fill-colour 05000000 is label 5"), std::string::npos);
  options_.fillWord = 5;
  EXPECT_EQ(voxelsOf(*open(input).source).at(mortonCode({2, 2, 2})), 5u);
}

/// A volume of labels says so; colours stay colours, whatever is asked of samples.
TEST_F(ChangesTest, LabelsAreThoseOfTheInput) {
  const auto save = [&](const std::string &provenance) {
    VolumeInfo info;
    info.format = *parseFormat("R(1, 1, 1)");
    info.extent = {2, 2, 2};
    info.voxels = 1;
    info.provenance = provenance;
    EXPECT_TRUE(Volume(info, {1, 7, 0, 0, 0, 0, 0, 0, 0}).save(folder_.path("v.hvx")));
  };
  options_.interior = Interior::Fill;
  save("coverage=samples colour-map=labels");
  EXPECT_NE(problem(folder_.path("v.hvx")).find("the inside of labels is filled with a label"),
            std::string::npos);
  save("coverage=cells");
  options_.colourMap = "labels";
  EXPECT_EQ(voxelsOf(*open(folder_.path("v.hvx")).source).size(), 1u);
}

/// What a volume says was done is not done again; other things are.
TEST_F(ChangesTest, VolumesRememberWhatWasDone) {
  const auto save = [&](const std::string &provenance) {
    VolumeInfo info;
    info.format = *parseFormat("R(3,3,3)");
    info.extent = {5, 5, 5};
    info.provenance = provenance;
    std::vector<std::uint32_t> words(1 + 512);
    words[0] = 1;
    for (std::uint32_t i = 0; i < 125; ++i)
      if (i != 62) {
        words[1 + i % 5 + 8 * (i / 5 % 5) + 64 * (i / 25)] = 7;
        ++info.voxels;
      }
    const std::string path = folder_.path("v.hvx");
    EXPECT_TRUE(Volume(info, std::move(words)).save(path));
    return path;
  };
  options_.interior = Interior::Fill;
  const Input kept = open(save("resolution=5 interior=fill fill-colour=ffffffff"));
  EXPECT_EQ(kept.interior, Interior::Keep);
  EXPECT_EQ(voxelsOf(*kept.source).size(), 124u);
  EXPECT_EQ(kept.provenance, "resolution=5 interior=fill fill-colour=ffffffff");
  const Input filled = open(save("resolution=5 interior=drop up=y"));
  EXPECT_EQ(filled.interiorVoxels, 1u);
  EXPECT_EQ(filled.provenance, "resolution=5 up=y interior=fill fill-colour=ffffffff");
}

TEST_F(ChangesTest, OfAMeshIsFilledByItsTriangles) {
  std::string text;
  // A cube in a cube that faces inwards: a hollow, which a flood would fill.
  for (const auto &[low, high] : {std::pair(0, 10), std::pair(7, 3)})
    for (int corner = 0; corner < 8; ++corner)
      for (int axis = 0; axis < 3; ++axis)
        text += (axis == 0 ? "v " : " ") + std::to_string((corner >> axis & 1) != 0 ? high : low) +
                (axis == 2 ? "\n" : "");
  for (int cube = 0; cube < 2; ++cube)
    for (const char *square : {"1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"}) {
      text += "f";
      for (const char digit : std::string(square))
        if (digit != ' ')
          text += " " + std::to_string(digit - '0' + 8 * cube);
      text += "\n";
    }
  options_.resolution = 20;
  options_.interior = Interior::Fill;
  const Input input = open(folder_.file("hollow.obj", text));
  EXPECT_TRUE(input.warnings.empty()) << input.warnings.front();
  EXPECT_EQ(input.interior, Interior::Fill);
  // The shells' voxels touch planes between voxels from both sides: the hollow has 6 of 8 cells a side left.
  EXPECT_EQ(voxelsOf(*input.source).size(), 20u * 20 * 20 - 6 * 6 * 6);
  EXPECT_NE(input.provenance.find(" interior=fill fill-colour=ffffffff"), std::string::npos);
}

} // namespace
} // namespace voxc
