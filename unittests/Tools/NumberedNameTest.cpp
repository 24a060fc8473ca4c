// Names of files that are numbered.
#include "common/NumberedName.h"

#include <gtest/gtest.h>

namespace voxc::tool {
namespace {

TEST(NumberedName, TakesSignsAndPercents) {
  for (const char *const text : {"s/###.png", "s/%03d.png"}) {
    const auto name = NumberedName::parse(text);
    ASSERT_TRUE(name) << text;
    EXPECT_EQ((*name)(7), "s/007.png");
    EXPECT_EQ((*name)(1234), "s/1234.png");
    EXPECT_EQ(name->asPercent(), "s/%03d.png");
  }
  EXPECT_EQ((*NumberedName::parse("%d"))(12), "12");
  EXPECT_EQ((*NumberedName::parse("#"))(12), "12");
  EXPECT_EQ(NumberedName::parse("############.png")->asPercent(), "%09d.png");
}

TEST(NumberedName, APercentMakesThePlaceAndSignsBesideItStay) {
  EXPECT_EQ((*NumberedName::parse("c#/a#%02d.png"))(3), "c#/a#03.png");
  // What is no right one is text.
  EXPECT_EQ((*NumberedName::parse("50%-##.png"))(3), "50%-03.png");
}

TEST(NumberedName, FilesOfAPatternAreCalledByWhatStandsBefore) {
  EXPECT_EQ(NumberedName::stemOf("a/slice-%03d.png"), "slice");
  EXPECT_EQ(NumberedName::stemOf("../ct/%d.png"), "ct");
  EXPECT_EQ(NumberedName::stemOf("%03d-brain.png"), "brain");
  EXPECT_EQ(NumberedName::stemOf("%03d.png"), "");
  EXPECT_EQ(NumberedName::stemOf("../%03d.png"), "");
  EXPECT_EQ(NumberedName::stemOf("a/50%.nii.gz"), "50%.nii");
  EXPECT_EQ(NumberedName::stemOf("walk.vox#2"), "walk");
}

TEST(NumberedName, IsNothingWithoutOnePlace) {
  for (const char *const text : {"", "a.png", "a-#-#.png", "%d-%d.png", "%s.png", "%0d.png", "%04", "%"})
    EXPECT_FALSE(NumberedName::parse(text)) << text;
}

} // namespace
} // namespace voxc::tool
