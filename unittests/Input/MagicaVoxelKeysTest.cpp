// Animations of MagicaVoxel files: keys, what lies between them, and those that repeat.
#include "Input/MagicaVoxel/VoxKeys.h"
#include "InputTesting.h"
#include "VoxBytes.h"

#include "voxc/Input/Input.h"

#include <gmock/gmock.h>

#include <limits>

namespace voxc {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Of the default palette, the colours 1 and 2.
constexpr std::uint32_t kFirstColour = 0xffffffff;
constexpr std::uint32_t kSecondColour = 0xffccffff;

std::string keyedTransform(Pairs node, const std::vector<Pairs> &keys) {
  std::string content = wordBytes({0}) + dictionaryBytes(node) +
                        wordBytes({1, 0xffffffff, 0xffffffff, static_cast<std::uint32_t>(keys.size())});
  for (const Pairs &key : keys)
    content += dictionaryBytes(key);
  return chunkBytes("nTRN", content);
}

/// The model 0 until the time `second`, from which on it is the model 1.
std::string keyedShape(Pairs node, const std::string &second) {
  return chunkBytes("nSHP", wordBytes({1}) + dictionaryBytes(node) + wordBytes({2, 0}) +
                                dictionaryBytes({{"_f", "0"}}) + wordBytes({1}) +
                                dictionaryBytes({{"_f", second}}));
}

class MagicaVoxelKeys : public OpenedInputs {
protected:
  /// A white voxel and a yellow one, of which the graph shows one.
  void write(const std::string &graph) {
    folder_.file("keys.vox", voxBytes(modelChunks(1, 1, 1, {{0, 0, 0, 1}}) +
                                      modelChunks(1, 1, 1, {{0, 0, 0, 2}}) + graph));
  }
  /// Where the voxel is along x, and its colour, at frame `frame` from 1 on.
  std::pair<double, std::uint32_t> seen(int frame) {
    const Voxels found = take(openInput(folder_.path("keys.vox#" + std::to_string(frame)), options_));
    return {map_[3].x, found.empty() ? 0 : found.begin()->second};
  }
};

TEST_F(MagicaVoxelKeys, PlacesMoveBetweenThemAndModelsHold) {
  // The node moves at the times 0, 2 and 5; its shape becomes another model at 3.
  write(keyedTransform({}, {{{"_f", "5"}, {"_t", "50 0 0"}},
                            {{"_f", "0"}, {"_t", "0 0 0"}},
                            {{"_f", "2"}, {"_t", "20 0 0"}}}) +
        keyedShape({}, "3"));
  const std::vector<std::pair<double, std::uint32_t>> expected{{0, kFirstColour},   {10, kFirstColour},
                                                               {20, kFirstColour},  {30, kSecondColour},
                                                               {40, kSecondColour}, {50, kSecondColour}};
  for (int frame = 1; frame <= 6; ++frame)
    EXPECT_EQ(seen(frame), expected[static_cast<std::size_t>(frame - 1)]) << frame;
  EXPECT_THAT(problem("keys.vox#7"), HasSubstr("there are 6"));
  take(openInput(folder_.path("keys.vox"), options_));
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("moves in 6 frames")));
}

TEST_F(MagicaVoxelKeys, NodesThatLoopRepeat) {
  // The place repeats after the times 1 to 3; the model after 0 and 1; ten frames are the shape's of another.
  const auto transform = [](const char *loop) {
    return keyedTransform({{"_loop", loop}},
                          {{{"_f", "1"}, {"_t", "10 0 0"}}, {{"_f", "3"}, {"_t", "30 0 0"}}});
  };
  const std::string other =
      chunkBytes("nSHP", wordBytes({9}) + dictionaryBytes({}) + wordBytes({2, 0}) + dictionaryBytes({}) +
                             wordBytes({0}) + dictionaryBytes({{"_f", "9"}}));
  write(transform("1") + keyedShape({{"_loop", "1"}}, "1") + other);
  const std::vector<double> places{30, 10, 20, 30, 10, 20, 30, 10, 20, 30};
  for (int frame = 1; frame <= 10; ++frame)
    EXPECT_EQ(seen(frame), std::pair(places[static_cast<std::size_t>(frame - 1)],
                                     frame % 2 == 1 ? kFirstColour : kSecondColour))
        << frame;
  EXPECT_THAT(warnings_, IsEmpty());
  write(transform("0") + keyedShape({}, "1") + other);
  EXPECT_EQ(seen(9), std::pair(30.0, kSecondColour));
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST(VoxKeys, AreRoundedTowardsZeroAndKeepTheirRotation) {
  const std::vector<VoxKey> keys{{.time = 0, .rotation = 17, .translation = {10, -10, 5}},
                                 {.time = 4, .rotation = 20, .translation = {0, 0, -5}}};
  const VoxKey key = keyAt(keys, false, 1);
  EXPECT_THAT(key.translation, ElementsAre(7, -7, 2));
  EXPECT_EQ(key.rotation, 17u);
  EXPECT_THAT(keyAt(keys, false, 3).translation, ElementsAre(2, -2, -2));
  EXPECT_EQ(keyAt(keys, false, 4).rotation, 20u);
  EXPECT_EQ(keyAt(keys, true, 5).rotation, 17u);
  EXPECT_EQ(framesOf(keys), 5);
}

TEST(VoxKeys, OfAnyNumbersAreNoTrouble) {
  constexpr std::int64_t kLow = std::numeric_limits<std::int32_t>::min();
  constexpr std::int64_t kHigh = std::numeric_limits<std::int32_t>::max();
  const std::vector<VoxKey> keys{{.time = kLow, .rotation = 4, .translation = {kLow, kHigh, 0}},
                                 {.time = kHigh, .rotation = 4, .translation = {kLow, kHigh, 0}}};
  for (const bool loop : {false, true})
    EXPECT_THAT(keyAt(keys, loop, 7).translation, ElementsAre(kLow, kHigh, 0));
  EXPECT_EQ(framesOf(keys), 1 << 20);
  EXPECT_EQ(framesOf({{.time = 7}}), 1);
  EXPECT_EQ(framesOf({}), 1);
  EXPECT_EQ(keyAt({}, true, 3).rotation, 4u);
  // Of two at one time the first counts.
  EXPECT_EQ(keyAt({{.time = 2, .model = 1}, {.time = 2, .model = 5}}, true, 3).model, 1u);
}

TEST_F(MagicaVoxelKeys, ThatAreNoWholeNumbersAreErrors) {
  const auto problemOf = [&](Pairs key) {
    write(keyedTransform({}, {key}) + shapeChunk(1, 0));
    return problem("keys.vox");
  };
  for (const char *place : {"1 2", "", "1 2 3 4", "1.5 2 3", "x", "1,2,3", "+-1 2 3", "99999999999 0 0"})
    EXPECT_THAT(problemOf({{"_t", place}}), HasSubstr("node 0 has the place '" + std::string(place) +
                                                      "', which is no three whole numbers"));
  EXPECT_THAT(problemOf({{"_f", "1.5"}}), HasSubstr("node 0 has the time '1.5', which is no whole number"));
  EXPECT_THAT(problemOf({{"_r", "x"}}),
              HasSubstr("has the rotation 'x', which is no whole number from 0 up"));
  EXPECT_THAT(problemOf({{"_r", "-1"}}), HasSubstr("the rotation '-1'"));
  EXPECT_THAT(problemOf({{"_r", "\n\x1b[31m"}}), HasSubstr("the rotation '??[31m'"));
  EXPECT_EQ(problemOf({{"_t", " +1 -2  3 "}, {"_f", "+0"}}), "none");
  EXPECT_EQ(problemOf({}), "none");
  write(transformChunk(0, 1, {}) + keyedShape({}, "soon"));
  EXPECT_THAT(problem("keys.vox"), HasSubstr("node 1 has the time 'soon', which is no whole number"));
}

TEST_F(MagicaVoxelKeys, ThatAreMoreThanFramesAreAnError) {
  write(keyedTransform({}, std::vector<Pairs>(kMostVoxFrames + 1)) + shapeChunk(1, 0));
  EXPECT_THAT(problem("keys.vox"), HasSubstr("node 0 has 1048577 keys; there may be 1048576"));
}

} // namespace
} // namespace voxc
