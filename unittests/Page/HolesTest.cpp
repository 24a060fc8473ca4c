// Holes of a page's texts: what stands in their place, and that a wrong name is an error.
#include "page/Holes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace voxc::page {
namespace {

using ::testing::HasSubstr;

std::string filled(std::string_view text) {
  const auto result = fill(text, {{"N", "2"}, {"empty", ""}});
  return result ? *result : "error: " + result.error().message;
}

TEST(Holes, AreFilledWhereverTheyStand) {
  EXPECT_EQ(filled("level ${N} at (${empty}); // ${N}${N}\n"), "level 2 at (); // 22\n");
  EXPECT_EQ(filled("no newline at the end ${N}"), "no newline at the end 2");
  EXPECT_EQ(filled("$N {N} $ a } b\n"), "$N {N} $ a } b\n");
  EXPECT_EQ(filled(""), "");
}

TEST(Holes, ThatNobodyNamedAreErrors) {
  EXPECT_THAT(filled("a\n${M}\n"), HasSubstr("there is no hole 'M'"));
  EXPECT_THAT(filled("${N"), HasSubstr("there is no hole"));
}

} // namespace
} // namespace voxc::page
