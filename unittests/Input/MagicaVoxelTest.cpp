// MagicaVoxel files: the scene graph, turns, colours, and what is left out.
#include "Mesh/SharedModels.h"
#include "Source/SourceTesting.h"
#include "VoxBytes.h"

#include "voxc/Input/Input.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace voxc {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class MagicaVoxel : public testing::Test {
protected:
  Expected<Input> open(const std::string &chunks) {
    return openInput(folder_.file("scene.vox", voxBytes(chunks)), options_);
  }
  Voxels voxels(const std::string &chunks) {
    auto input = open(chunks);
    EXPECT_TRUE(input) << input.error().message;
    if (!input)
      return {};
    warnings_ = input->warnings;
    extent_ = input->source->extent();
    return voxelsOf(*input->source);
  }

  TemporaryFolder folder_;
  InputOptions options_;
  std::vector<std::string> warnings_;
  Int3 extent_;
};

/// Of the default palette.
constexpr std::uint32_t kWhite = 0xffffffff;
constexpr std::uint32_t kPaleYellow = 0xffccffff;

TEST_F(MagicaVoxel, UpIsTurnedFromZToY) {
  EXPECT_EQ(voxels(modelChunks(3, 4, 5, {{2, 1, 4, 1}, {0, 0, 0, 2}})),
            (Voxels{{mortonCode({2, 4, 2}), kWhite}, {mortonCode({0, 0, 3}), kPaleYellow}}));
  EXPECT_EQ(extent_, (Int3{3, 5, 4}));
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(MagicaVoxel, DefaultPaletteIsThePublishedOne) {
  const auto colour = [&](int number) {
    const Voxels found = voxels(modelChunks(1, 1, 1, {{0, 0, 0, number}}));
    return found.empty() ? 0 : found.begin()->second;
  };
  // The cube: blue falls first, then green, then red; black is left out.
  EXPECT_EQ(colour(1), 0xffffffffu);
  EXPECT_EQ(colour(6), 0xff00ffffu);
  EXPECT_EQ(colour(7), 0xffffccffu);
  EXPECT_EQ(colour(37), 0xffffffccu);
  EXPECT_EQ(colour(215), 0xff330000u);
  // The ramps.
  EXPECT_EQ(colour(216), 0xff0000eeu);
  EXPECT_EQ(colour(225), 0xff000011u);
  EXPECT_EQ(colour(226), 0xff00ee00u);
  EXPECT_EQ(colour(236), 0xffee0000u);
  EXPECT_EQ(colour(246), 0xffeeeeeeu);
  EXPECT_EQ(colour(247), 0xffddddddu);
  EXPECT_EQ(colour(255), 0xff111111u);
}

TEST_F(MagicaVoxel, ColourZeroIsEmptyBlackIsNot) {
  std::string palette = wordBytes({0xff000000, 0, 0x00010203}) + std::string(253 * 4, '\x7f');
  EXPECT_EQ(voxels(modelChunks(4, 1, 1, {{0, 0, 0, 1}, {1, 0, 0, 0}, {2, 0, 0, 2}, {3, 0, 0, 3}}) +
                   chunkBytes("RGBA", palette)),
            (Voxels{{mortonCode({0, 0, 0}), 0xff000000}, {mortonCode({3, 0, 0}), 0x00010203}}));
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("1 voxel is dropped, of the colour 0"),
                                     HasSubstr("1 voxel is dropped, of a colour whose word is 0"),
                                     HasSubstr("1 voxel is kept, though of a colour of alpha 0")));
}

TEST_F(MagicaVoxel, FirstOfSeveralModelsWithoutAGraphIsTaken) {
  EXPECT_EQ(voxels(modelChunks(1, 1, 1, {{0, 0, 0, 2}}) + modelChunks(2, 1, 1, {{1, 0, 0, 1}})),
            (Voxels{{0, kPaleYellow}}));
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("2 models without a scene graph")));
}

TEST_F(MagicaVoxel, ModelsTurnAboutTheirMiddleRoundedDown) {
  // The middle of 3 x 2 x 1 cells is (1, 1, 0); the box is that of the model's cells.
  const std::string model = modelChunks(3, 2, 1, {{0, 0, 0, 1}, {2, 1, 0, 2}});
  const std::string other = modelChunks(1, 1, 1, {{0, 0, 0, 1}});
  // A model of one cell at (10, 10, 10) and the other around (20, 20, 20).
  const auto at = [&](const char *rotation) {
    return voxels(model + other + transformChunk(0, 1, {}) + groupChunk(1, {2, 4}) +
                  transformChunk(2, 3, {{"_t", "20 20 20"}, {"_r", rotation}}) + shapeChunk(3, 0) +
                  transformChunk(4, 5, {{"_t", "10 10 10"}}) + shapeChunk(5, 1));
  };
  const auto code = [&](int x, int y, int z) {
    // Cells of the scene whose low corner is (10, 10, 10), turned.
    return mortonCode({x - 10, z - 10, extent_.z - 1 - (y - 10)});
  };
  Voxels found = at("4"); // No turn: x from 19 to 21, y from 19 to 20.
  EXPECT_EQ(
      found,
      (Voxels{{code(10, 10, 10), kWhite}, {code(19, 19, 20), kWhite}, {code(21, 20, 20), kPaleYellow}}));
  found = at("20"); // x is negated: from -(21 - 20 + 1) to ...: 18 to 20.
  EXPECT_EQ(
      found,
      (Voxels{{code(10, 10, 10), kWhite}, {code(20, 19, 20), kWhite}, {code(18, 20, 20), kPaleYellow}}));
  found = at("1"); // The rows take y, x, z: x from 19 to 20, y from 19 to 21.
  EXPECT_EQ(
      found,
      (Voxels{{code(10, 10, 10), kWhite}, {code(19, 19, 20), kWhite}, {code(20, 21, 20), kPaleYellow}}));
  found = at("17"); // (x, y) becomes (-y, x): a quarter turn; x from 19 to 20, y from 19 to 21.
  EXPECT_EQ(
      found,
      (Voxels{{code(10, 10, 10), kWhite}, {code(20, 19, 20), kWhite}, {code(19, 21, 20), kPaleYellow}}));
}

/// All 48 turns under each other, against matrices in floating point applied to the middles of cells.
TEST_F(MagicaVoxel, NestedTurnsAreThoseOfMatrices) {
  using Matrix = std::array<std::array<double, 3>, 3>;
  const auto matrixOf = [](unsigned byte) {
    Matrix matrix{};
    const unsigned axes[3] = {byte & 3, byte >> 2 & 3, 3 - (byte & 3) - (byte >> 2 & 3)};
    for (unsigned row = 0; row < 3; ++row)
      matrix[row][axes[row]] = byte >> (4 + row) & 1 ? -1 : 1;
    return matrix;
  };
  const auto apply = [](const Matrix &m, std::array<double, 3> p, std::array<double, 3> t) {
    std::array<double, 3> result = t;
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t i = 0; i < 3; ++i)
        result[row] += m[row][i] * p[i];
    return result;
  };
  std::vector<unsigned> turns;
  for (unsigned byte = 0; byte < 128; ++byte)
    if ((byte & 3) < 3 && (byte >> 2 & 3) < 3 && (byte & 3) != (byte >> 2 & 3))
      turns.push_back(byte);
  ASSERT_EQ(turns.size(), 48u);
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    const unsigned outer = turns[random() % 48];
    const unsigned inner = turns[random() % 48];
    // A second model of one cell at (-100, -100, -100) fixes the corner of the box.
    const std::string chunks =
        modelChunks(3, 4, 7, {{2, 0, 5, 1}}) + modelChunks(1, 1, 1, {{0, 0, 0, 2}}) +
        transformChunk(0, 1, {}) + groupChunk(1, {2, 6}) +
        transformChunk(2, 3, {{"_r", std::to_string(outer)}, {"_t", "5 -6 7"}}) + groupChunk(3, {4}) +
        transformChunk(4, 5, {{"_r", std::to_string(inner)}, {"_t", "1 2 -3"}}) + shapeChunk(5, 0) +
        transformChunk(6, 7, {{"_t", "-100 -100 -100"}}) + shapeChunk(7, 1);
    const Voxels found = voxels(chunks);
    std::array<double, 3> middle{2.5 - 1, 0.5 - 2, 5.5 - 3};
    middle = apply(matrixOf(outer), apply(matrixOf(inner), middle, {1, 2, -3}), {5, -6, 7});
    const Int3 cell{static_cast<int>(std::floor(middle[0])) + 100,
                    static_cast<int>(std::floor(middle[1])) + 100,
                    static_cast<int>(std::floor(middle[2])) + 100};
    ASSERT_EQ(found, (Voxels{{mortonCode({0, 0, extent_.z - 1}), kPaleYellow},
                             {mortonCode({cell.x, cell.z, extent_.z - 1 - cell.y}), kWhite}}))
        << outer << " " << inner;
  }
}

TEST_F(MagicaVoxel, FirstFrameInTimeCounts) {
  const std::string frames = wordBytes({0, 0, 1, 0xffffffff, 0xffffffff, 2}) +
                             dictionaryBytes({{"_f", "5"}, {"_t", "9 0 0"}}) +
                             dictionaryBytes({{"_f", "2"}, {"_t", "-4 0 0"}});
  const std::string shape = wordBytes({3, 0, 2, 0}) + dictionaryBytes({{"_f", "7"}}) + wordBytes({1}) +
                            dictionaryBytes({{"_f", "1"}});
  const std::string one = modelChunks(1, 1, 1, {{0, 0, 0, 1}});
  const std::string two = modelChunks(1, 1, 1, {{0, 0, 0, 2}});
  EXPECT_EQ(voxels(one + two + chunkBytes("nTRN", frames) + groupChunk(1, {3, 4}) +
                   chunkBytes("nSHP", shape) + transformChunk(4, 5, {{"_t", "2 0 0"}}) + shapeChunk(5, 0)),
            (Voxels{{mortonCode({0, 0, 0}), kPaleYellow}, {mortonCode({2, 0, 0}), kWhite}}));
}

TEST_F(MagicaVoxel, AFrameIsTakenByItsNumber) {
  const std::string path = folder_.file("walk.vox", voxBytes(modelChunks(1, 1, 1, {{0, 0, 0, 1}}) +
                                                             modelChunks(2, 1, 1, {{1, 0, 0, 2}}) +
                                                             modelChunks(3, 1, 1, {{2, 0, 0, 1}})));
  const auto third = openInput(path + "#3", options_);
  ASSERT_TRUE(third) << third.error().message;
  EXPECT_EQ(voxelsOf(*third->source), (Voxels{{mortonCode({2, 0, 0}), kWhite}}));
  EXPECT_THAT(third->warnings, IsEmpty());
  EXPECT_EQ(voxelsOf(*openInput(path + "#1", options_)->source), (Voxels{{0, kWhite}}));
  EXPECT_THAT(openInput(path + "#4", options_).error().message, HasSubstr("it has no frame 4; there are 3"));
  EXPECT_THAT(openInput(path + "#0", options_).error().message, HasSubstr("names no frame; the first is #1"));
  EXPECT_THAT(openInput(path + "#99999999999", options_).error().message, HasSubstr("names no frame"));
  // A file may be called so all the same.
  const std::string other = folder_.file("walk#2.vox", voxBytes(modelChunks(1, 1, 1, {{0, 0, 0, 2}})));
  EXPECT_EQ(voxelsOf(*openInput(other, options_)->source), (Voxels{{0, kPaleYellow}}));
}

TEST_F(MagicaVoxel, DroppedMaterialsAreTold) {
  const auto material = [](std::uint32_t number, const char *type) {
    return chunkBytes("MATL", wordBytes({number}) + dictionaryBytes({{"_weight", "1"}, {"_type", type}}));
  };
  const std::string model = modelChunks(4, 1, 1, {{0, 0, 0, 1}, {1, 0, 0, 2}, {2, 0, 0, 3}, {3, 0, 0, 4}});
  voxels(model + material(1, "_diffuse") + material(2, "_glass") + material(3, "_emit") +
         material(4, "_glass") + material(5, "_metal"));
  EXPECT_THAT(
      warnings_,
      ElementsAre("of materials only the colours are kept; dropped: glass of 2 colours, emission of 1 "
                  "colour"));
  voxels(model + material(1, "_diffuse") + material(5, "_metal"));
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(MagicaVoxel, MaterialsInPlaceOfColours) {
  const auto material = [](std::uint32_t number, const char *type, const char *rough, const char *metal) {
    return chunkBytes("MATL", wordBytes({number}) +
                                  dictionaryBytes({{"_rough", rough}, {"_metal", metal}, {"_type", type}}));
  };
  const std::string path = folder_.file(
      "m.vox",
      voxBytes(modelChunks(5, 1, 1, {{0, 0, 0, 1}, {1, 0, 0, 2}, {2, 0, 0, 3}, {3, 0, 0, 4}, {4, 0, 0, 5}}) +
               material(1, "_metal", "0.2", "0.6") + material(2, "_emit", "0.2", "0.6") +
               material(3, "_glass", "0.4", "1") + material(4, "_metal", "nan", "-3")));
  const auto wordsOf = [&](MaterialWords words) {
    options_.materialWords = words;
    const auto input = openInput(path, options_);
    EXPECT_TRUE(input) << input.error().message;
    std::vector<std::uint32_t> row(5);
    for (const auto &[code, word] : voxelsOf(*input->source))
      row[static_cast<std::size_t>(mortonCell(code).x)] = word;
    return row;
  };
  const std::vector<std::uint32_t> colours = wordsOf(MaterialWords::Colours);
  EXPECT_THAT(wordsOf(MaterialWords::Emission),
              ElementsAre(rgba(0, 0, 0), colours[1], rgba(0, 0, 0), rgba(0, 0, 0), rgba(0, 0, 0)));
  EXPECT_THAT(
      wordsOf(MaterialWords::MetallicRoughness),
      ElementsAre(rgba(0, 51, 153), rgba(0, 255, 0), rgba(0, 102, 0), rgba(0, 255, 0), rgba(0, 255, 0)));
}

TEST_F(MagicaVoxel, HiddenNodesAndLayersAreLeftOut) {
  const std::string models = modelChunks(1, 1, 1, {{0, 0, 0, 1}});
  const auto scene = [&](const std::string &second) {
    return models + transformChunk(0, 1, {}) + groupChunk(1, {2, 4}) + transformChunk(2, 3, {}) +
           shapeChunk(3, 0) + second;
  };
  const Voxels one{{0, kWhite}};
  EXPECT_EQ(voxels(scene(transformChunk(4, 5, {{"_t", "3 0 0"}}) + shapeChunk(5, 0))).size(), 2u);
  EXPECT_EQ(voxels(scene(transformChunk(4, 5, {{"_t", "3 0 0"}}, {{"_hidden", "1"}}) + shapeChunk(5, 0))),
            one);
  EXPECT_EQ(voxels(scene(transformChunk(4, 5, {{"_t", "3 0 0"}}) + shapeChunk(5, 0, {{"_hidden", "1"}}))),
            one);
  EXPECT_EQ(voxels(scene(transformChunk(4, 5, {{"_t", "3 0 0"}}, {}, 7) + shapeChunk(5, 0) +
                         chunkBytes("LAYR", wordBytes({7}) + dictionaryBytes({{"_hidden", "1"}}) +
                                                wordBytes({0xffffffff})))),
            one);
  EXPECT_EQ(voxels(models + transformChunk(0, 1, {}, {{"_hidden", "1"}}) + shapeChunk(1, 0)), Voxels());
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("hidden")));
}

TEST_F(MagicaVoxel, WhatIsLeftOutOfASceneIsTold) {
  const std::string models = modelChunks(1, 1, 1, {{0, 0, 0, 1}}) + modelChunks(1, 1, 1, {{0, 0, 0, 2}});
  const std::string graph =
      transformChunk(0, 1, {}) + groupChunk(1, {2, 4}) + transformChunk(2, 3, {}) + shapeChunk(3, 0);
  voxels(models + graph + transformChunk(4, 5, {}, {{"_hidden", "1"}}) + shapeChunk(5, 0) +
         chunkBytes("ABCD", "x") + chunkBytes("rCAM", wordBytes({0}) + dictionaryBytes({})));
  EXPECT_THAT(warnings_, ElementsAre("hidden parts of its scene are left out: 1 node",
                                     "1 model is left out, which its scene does not place",
                                     "chunks that are not known are left out: ABCD",
                                     "chunks and attributes of its editor, which change no voxel, are not "
                                     "used: rCAM"));
  voxels(models + graph + transformChunk(4, 5, {}) + shapeChunk(5, 1));
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(MagicaVoxel, BytesBehindTheVoxelsOfAModelAreTold) {
  const std::string model = chunkBytes("SIZE", wordBytes({2, 1, 1}));
  const std::string white("\0\0\0\1", 4), other("\1\0\0\1", 4);
  const Voxels one{{0, kWhite}};
  EXPECT_EQ(voxels(model + chunkBytes("XYZI", wordBytes({1}) + white)), one);
  EXPECT_THAT(warnings_, IsEmpty());
  EXPECT_EQ(voxels(model + chunkBytes("XYZI", wordBytes({1}) + white + other)), one);
  EXPECT_THAT(warnings_, ElementsAre("4 bytes are left out, which lie behind the voxels of its models"));
}

TEST_F(MagicaVoxel, FirstOfOverlappingModelsWins) {
  const std::string models = modelChunks(1, 1, 1, {{0, 0, 0, 1}}) + modelChunks(1, 1, 1, {{0, 0, 0, 2}});
  EXPECT_EQ(
      voxels(models + transformChunk(0, 1, {}) + groupChunk(1, {5, 3}) + shapeChunk(3, 0) + shapeChunk(5, 1)),
      (Voxels{{0, kPaleYellow}}));
}

TEST_F(MagicaVoxel, CopiesByReferenceShareNodes) {
  EXPECT_EQ(voxels(modelChunks(1, 1, 1, {{0, 0, 0, 1}}) + transformChunk(0, 1, {}) + groupChunk(1, {2, 3}) +
                   transformChunk(2, 4, {{"_t", "1 0 0"}}) + transformChunk(3, 4, {{"_t", "4 0 0"}}) +
                   shapeChunk(4, 0))
                .size(),
            2u);
}

TEST_F(MagicaVoxel, NestingIsAsDeepAsTheFileLikes) {
  std::string chunks = modelChunks(1, 1, 1, {{0, 0, 0, 1}});
  constexpr std::uint32_t kDepth = 200000;
  for (std::uint32_t i = 0; i < kDepth; ++i)
    chunks += groupChunk(i, {i + 1});
  EXPECT_EQ(voxels(chunks + shapeChunk(kDepth, 0)), (Voxels{{0, kWhite}}));
}

struct SharedScene {
  const char *name;
  std::size_t voxels;
  Int3 extent;
};

TEST_F(MagicaVoxel, SharedScenesHaveTheirVoxels) {
  VOXC_SKIP_WITHOUT("vox/monu1.vox");
  for (const SharedScene &scene :
       {SharedScene{"monu1", 156942, {126, 118, 126}}, SharedScene{"monu3", 848469, {112, 120, 112}},
        SharedScene{"monu10", 150764, {72, 126, 72}}, SharedScene{"monu16", 194300, {117, 126, 117}},
        SharedScene{"teapot", 28411, {126, 61, 80}}, SharedScene{"dragon", 40265, {126, 89, 57}},
        SharedScene{"menger", 160000, {81, 81, 81}}, SharedScene{"nature", 75835, {120, 60, 120}},
        SharedScene{"chr_knight", 398, {20, 20, 21}},
        SharedScene{"mmmm_scene_store8", 441118, {124, 68, 124}},
        SharedScene{"ogt_test_groups", 1754, {92, 48, 21}}}) {
    auto input = openInput(sharedModel("vox/") + scene.name + ".vox", options_);
    ASSERT_TRUE(input) << input.error().message;
    EXPECT_EQ(input->source->extent(), scene.extent) << scene.name;
    EXPECT_EQ(voxelsOf(*input->source).size(), scene.voxels) << scene.name;
  }
}

} // namespace
} // namespace voxc
