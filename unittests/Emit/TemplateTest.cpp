// Templates: what their names stand for, and that a wrong name is an error.
#include "Emit/Template.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace voxc {
namespace {

using ::testing::HasSubstr;

const TemplateNames kNames = {{{"N", "2"}, {"empty", ""}}, {{"on", true}, {"off", false}}};

std::string fill(std::string_view text) {
  const auto filled = fillTemplate(text, kNames);
  return filled ? *filled : "error in " + filled.error().message;
}

TEST(Template, FillsHolesWhereverTheyStand) {
  EXPECT_EQ(fill("int level_${N}_at(${empty}); // ${N}${N}\n"), "int level_2_at(); // 22\n");
  EXPECT_EQ(fill("no newline at the end ${N}"), "no newline at the end 2");
  EXPECT_EQ(fill("$N {N} %N a % b\n"), "$N {N} %N a % b\n");
  EXPECT_EQ(fill(""), "");
}

TEST(Template, LeavesOutWhatDoesNotApply) {
  EXPECT_EQ(fill("a\n%if on\nb\n%else\nc\n%end\nd\n"), "a\nb\nd\n");
  EXPECT_EQ(fill("a\n%if off\nb\n%else\nc\n%end\nd\n"), "a\nc\nd\n");
  EXPECT_EQ(fill("%if off\n%if on\na\n%else\nb\n%end\n%else\n%if on\nc\n%end\nd\n%end\n"), "c\nd\n");
}

TEST(Template, KnowsEveryNameOrSaysSo) {
  EXPECT_THAT(fill("a\n${M}\n"), HasSubstr("line 2: there is no hole 'M'"));
  EXPECT_THAT(fill("%if maybe\n%end\n"), HasSubstr("there is no condition 'maybe'"));
  // In what does not apply too.
  EXPECT_THAT(fill("%if off\n${M}\n%end\n"), HasSubstr("line 2: there is no hole 'M'"));
  EXPECT_THAT(fill("%if off\n%if maybe\n%end\n%end\n"), HasSubstr("line 2: there is no condition 'maybe'"));
  EXPECT_THAT(fill("${N\n"), HasSubstr("there is no hole"));
}

TEST(Template, BalancesItsConditions) {
  EXPECT_THAT(fill("%if on\na\n"), HasSubstr("a %if has no %end"));
  for (const char *text : {"%end\n", "%else\n", "%if on\n%else\n%else\n%end\n", "%elif on\n", "%ends\n"})
    EXPECT_THAT(fill(text), HasSubstr("that fits here")) << text;
}

} // namespace
} // namespace voxc
