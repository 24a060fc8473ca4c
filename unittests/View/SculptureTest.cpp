// A volume that is edited: its strokes, its frames, and what a scene on another device has of them.
#include "Hill.h"

#include "view/Sculpture.h"
#include "voxc/Construct/Frames.h"
#include "voxc/Source/Edit.h"
#include "voxc/Volume/Frames.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace voxc::view {
namespace {

using ::testing::HasSubstr;

constexpr Int3 kExtent{16, 16, 16};

/// A volume of two frames: layers of different heights.
Model animated() {
  const Format format = *parseFormat("R(4^3)");
  const auto open = [](std::size_t index) -> Expected<std::unique_ptr<VoxelSource>> {
    return makeFunctionSource(kExtent,
                              [=](Int3 c) { return c.y <= static_cast<int>(index) ? 0xff00ffffu : 0u; });
  };
  auto built = buildFrames(format, 2, open);
  EXPECT_TRUE(built) << built.error().message;
  return {std::make_shared<const Volume>(std::move(built->volume)), format, "R(4, 4, 4)"};
}

SceneMaker animatedMaker() {
  SceneMaker maker = hillMaker();
  maker.makeModel = [](const std::string &, const Progress &) -> Expected<Model> { return animated(); };
  return maker;
}

/// Sets one voxel, as a stroke of its own.
void strike(Sculpture &sculpture, Int3 voxel) {
  sculpture.begin();
  EXPECT_TRUE(sculpture.apply(*makeChange({voxel, {1, 1, 1}, 0xff0000ff, nullptr})));
}

bool isRed(const Volume &volume, Int3 voxel) { return volume.lookup(voxel).value == 0xff0000ff; }

TEST(Sculpture, AStrokeThatMeetsNothingLeavesWhatWasUndone) {
  Sculpture sculpture(animated().volume);
  ASSERT_TRUE(sculpture.prepare());
  strike(sculpture, {3, 9, 3});
  EXPECT_TRUE(sculpture.isEdited());
  EXPECT_TRUE(sculpture.undo());
  sculpture.begin(); // Of a stroke that goes on without a stamp.
  EXPECT_FALSE(sculpture.undo());
  EXPECT_FALSE(sculpture.isEdited());
  EXPECT_EQ(sculpture.frozen(), nullptr);
  EXPECT_TRUE(sculpture.redo());
  EXPECT_TRUE(isRed(*sculpture.volume(), {3, 9, 3}));
}

TEST(Sculpture, StrokesOfFramesThatWereLeftAreKept) {
  Sculpture sculpture(animated().volume);
  ASSERT_TRUE(sculpture.prepare());
  ASSERT_TRUE(sculpture.showFrame(1));
  EXPECT_FALSE(sculpture.isEdited());
  strike(sculpture, {3, 9, 3});
  ASSERT_TRUE(sculpture.showFrame(0));
  EXPECT_TRUE(sculpture.isEdited());
  EXPECT_NE(sculpture.frozen(), nullptr);
  EXPECT_FALSE(isRed(*sculpture.volume(), {3, 9, 3}));
  const auto frames = sculpture.frozenFrames();
  ASSERT_TRUE(frames && *frames);
  EXPECT_EQ(framesOf(**frames).size(), 2u);
}

TEST(Sculpture, AnotherDeviceHasAllFramesAndStrokes) {
  const SceneMaker maker = animatedMaker();
  const auto first = *makeScene(maker, {}, nullptr, {});
  ASSERT_TRUE(first->sculpture->prepare());
  ASSERT_TRUE(first->sculpture->showFrame(1));
  strike(*first->sculpture, {3, 9, 3});
  ASSERT_TRUE(first->sculpture->showFrame(0));
  const auto second = makeScene(maker, {first->model.text, "other"}, first.get(), {});
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_EQ((*second)->sculpture->frames(), 2u);
  ASSERT_TRUE((*second)->sculpture->prepare());
  EXPECT_FALSE(isRed(*(*second)->volume(), {3, 9, 3}));
  ASSERT_TRUE((*second)->sculpture->showFrame(1));
  EXPECT_TRUE(isRed(*(*second)->volume(), {3, 9, 3}));
  // It has no history there, and would be lost in a format that is built of the input.
  const auto third = makeScene(maker, {"G(4)", "other"}, second->get(), {});
  ASSERT_FALSE(third);
  EXPECT_THAT(third.error().message, HasSubstr("write it (F2)"));
}

TEST(Sculpture, AFrameThatIsLookedAtIsNoEdit) {
  const SceneMaker maker = animatedMaker();
  const auto first = *makeScene(maker, {}, nullptr, {});
  ASSERT_TRUE(first->sculpture->prepare());
  ASSERT_TRUE(first->sculpture->showFrame(1));
  EXPECT_TRUE(makeScene(maker, {"G(4)", ""}, first.get(), {}));
}

} // namespace
} // namespace voxc::view
