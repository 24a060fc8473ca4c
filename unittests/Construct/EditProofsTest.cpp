// An edit makes no voxel of which the format says that there is none, and what one that failed made counts
// for nothing.
#include "EditTesting.h"

#include "voxc/Construct/EditableVolume.h"
#include "voxc/Source/Sources.h"

#include <gtest/gtest.h>

namespace voxc {
namespace {

TEST(EditProofs, AWordThatTheFormatCannotKeepLeavesAllAsItWas) {
  const auto source = makeBuiltinSource("terrain", 32);
  const auto volume = test::buildVolume(test::formatWith("R(5^3)", {"visible-voxels"}), **source);
  ASSERT_TRUE(volume);
  auto edited = EditableVolume::create(*volume);
  ASSERT_TRUE(edited) << edited.error().message;
  const auto before = test::wordsOf(*edited->volume());
  const auto failed = edited->apply(*makeFunctionChange(
      {0, 0, 0}, {32, 32, 32}, [](Int3 at, std::uint32_t) { return at.x < 20 ? 0xff00ff00 : 0x00123456u; }));
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().message.substr(0, 56), "voxel (20, 0, 0) would have an alpha of 0, but the forma");
  EXPECT_EQ(test::wordsOf(*edited->volume()), before);
  EXPECT_EQ(edited->voxels(), volume->info().voxels);
  ASSERT_TRUE(edited->apply(*makeBoxChange({0, 0, 0}, {3, 3, 3}, 0xff00ff00)));
  EXPECT_EQ(edited->volume()->lookup({1, 2, 0}).value, 0xff00ff00);
}

TEST(EditProofs, AnEditThatFailsProvesNoColour) {
  constexpr std::uint32_t kRed = 0xff0000ff, kGreen = 0xff00ff00, kBlue = 0xffff0000;
  const auto source = makeBuiltinSource("empty", 16);
  const auto volume = test::buildVolume(test::formatWith("G(4)", {"constant-colour"}), **source);
  ASSERT_TRUE(volume);
  auto edited = EditableVolume::create(*volume);
  ASSERT_TRUE(edited) << edited.error().message;
  const auto twoColours = makeFunctionChange({0, 0, 0}, {16, 16, 16},
                                             [](Int3 at, std::uint32_t) { return at.x < 5 ? kRed : kGreen; });
  ASSERT_FALSE(edited->apply(*twoColours));
  const auto blue = edited->apply(*makeBoxChange({1, 2, 3}, {2, 2, 2}, kBlue));
  ASSERT_TRUE(blue) << blue.error().message;
  EXPECT_EQ(edited->voxels(), 8u);
  EXPECT_EQ(edited->volume()->words()[1], kBlue);
  ASSERT_FALSE(edited->apply(*twoColours));
  EXPECT_FALSE(edited->apply(*makeBoxChange({8, 8, 8}, {1, 1, 1}, kRed))) << "all others are blue";
  EXPECT_TRUE(edited->apply(*makeBoxChange({8, 8, 8}, {1, 1, 1}, kBlue)));
}

TEST(EditProofs, AColourIsNoLabel) {
  const auto source = makeFunctionSource({32, 32, 32}, [](Int3 at) { return at.x == at.y ? 3u : 0u; });
  const auto volume = test::buildVolume(test::formatWith("G(5)", {"material=3"}), *source);
  ASSERT_TRUE(volume);
  auto edited = EditableVolume::create(*volume);
  ASSERT_TRUE(edited) << edited.error().message;
  const auto failed = edited->apply(*makeBoxChange({1, 2, 3}, {1, 1, 1}, 0xff0000ff));
  ASSERT_FALSE(failed);
  EXPECT_EQ(
      failed.error().message,
      "voxel (1, 2, 3) would be of a colour, but the format states payload=material(3), labels from 1 to "
      "7; the word of a label is its number, as label 5 is written 05000000 in digits rrggbbaa");
  ASSERT_TRUE(edited->apply(*makeBoxChange({1, 2, 3}, {1, 1, 1}, 5)));
  EXPECT_EQ(edited->volume()->lookup({1, 2, 3}).value, 5u);
}

} // namespace
} // namespace voxc
