// Names of files that are numbered.
#include "common/NumberedName.h"

#include <gtest/gtest.h>

namespace voxc::tool {
namespace {

TEST(NumberedName, TakesSignsAndPercents) {
  for (const char *const text : {"s/###.png", "s/%03d.png"}) {
    const auto name = parseNumberedName(text);
    ASSERT_TRUE(name) << text;
    EXPECT_EQ((*name)(7), "s/007.png");
    EXPECT_EQ((*name)(1234), "s/1234.png");
    EXPECT_EQ(asPercent(*name), "s/%03d.png");
  }
  EXPECT_EQ((*parseNumberedName("%d"))(12), "12");
  EXPECT_EQ((*parseNumberedName("#"))(12), "12");
  EXPECT_EQ(asPercent(*parseNumberedName("############.png")), "%09d.png");
}

TEST(NumberedName, APercentMakesThePlaceAndSignsBesideItStay) {
  EXPECT_EQ((*parseNumberedName("c#/a#%02d.png"))(3), "c#/a#03.png");
  // What is no right one is text.
  EXPECT_EQ((*parseNumberedName("50%-##.png"))(3), "50%-03.png");
}

TEST(NumberedName, FilesOfAPatternAreCalledByWhatStandsBefore) {
  EXPECT_EQ(stemOfNumbered("a/slice-%03d.png"), "slice");
  EXPECT_EQ(stemOfNumbered("../ct/%d.png"), "ct");
  EXPECT_EQ(stemOfNumbered("%03d-brain.png"), "brain");
  EXPECT_EQ(stemOfNumbered("%03d.png"), "");
  EXPECT_EQ(stemOfNumbered("../%03d.png"), "");
  EXPECT_EQ(stemOfNumbered("a/50%.nii.gz"), "50%.nii");
  EXPECT_EQ(stemOfNumbered("walk.vox#2"), "walk");
}

TEST(NumberedName, IsNothingWithoutOnePlace) {
  for (const char *const text : {"", "a.png", "a-#-#.png", "%d-%d.png", "%s.png", "%0d.png", "%04", "%"})
    EXPECT_FALSE(parseNumberedName(text)) << text;
}

} // namespace
} // namespace voxc::tool
