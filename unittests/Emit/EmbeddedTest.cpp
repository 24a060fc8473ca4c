// Kernel functions as text for others: which names get a prefix, and who gets a volume.
#include "Emit/Embedded.h"
#include "voxc/Emit/Emit.h"

#include <gtest/gtest.h>

namespace voxc {
namespace {

TEST(Embedded, PutsThePrefixBeforeWhatIsDeclaredOutermost) {
  EXPECT_EQ(embedded("const int SIDE = 4; // SIDE of a cube.\n"
                     "struct Gap {\n  int count;\n};\n"
                     "int twice(int count) { return SIDE * count; }\n"
                     "int of(const Gap gap) { return twice(gap.count); }\n",
                     "p_"),
            "const int p_SIDE = 4; // SIDE of a cube.\n"
            "struct p_Gap {\n  int count;\n};\n"
            "VOXC_FUNCTION int p_twice(int count) { return p_SIDE * count; }\n"
            "VOXC_FUNCTION int p_of(VOXC_IN(p_Gap) gap) { return p_twice(gap.count); }\n");
}

TEST(Embedded, LeavesMembersThatAreCalledAsFunctionsAre) {
  EXPECT_EQ(embedded("struct Exit {\n  bool passed;\n};\nbool passed(Exit e) { return e.passed; }\n", "p_"),
            "struct p_Exit {\n  bool passed;\n};\n"
            "VOXC_FUNCTION bool p_passed(p_Exit e) { return e.passed; }\n");
}

TEST(Embedded, HandsAVolumeToAllThatLoad) {
  EXPECT_EQ(embedded("uint load_word(uint at) { return at; }\n"
                     "uint first() { return load_word(0u); }\n"
                     "uint sum(uint a, uint b) { return a + b; }\n"
                     "uint p_twice(uint a) { return sum(first(), first()) + min(a, 1u); }\n",
                     "p_"),
            "VOXC_FUNCTION uint p_load_word(VOXC_VOLUME volume, uint at) { return at; }\n"
            "VOXC_FUNCTION uint p_first(VOXC_VOLUME volume) { return p_load_word(volume, 0u); }\n"
            "VOXC_FUNCTION uint p_sum(uint a, uint b) { return a + b; }\n"
            "VOXC_FUNCTION uint p_twice(VOXC_VOLUME volume, uint a) "
            "{ return p_sum(p_first(volume), p_first(volume)) + min(a, 1u); }\n");
}

TEST(Embedded, SpellsWhatTheLanguagesDifferInAsMacros) {
  EXPECT_EQ(
      embedded("OUT_OF_LINE void f(inout vec3 a, out bool b, const ivec3 c) { const int d = c.x; }\n", "p_"),
      "VOXC_SELDOM void p_f(VOXC_INOUT(vec3) a, VOXC_OUT(bool) b, VOXC_IN(ivec3) c) { const int d = c.x; "
      "}\n");
}

TEST(Embedded, NamesOfHeadersAreMadeOfFormats) {
  const auto nameOf = [](const char *text) { return headerName(layoutOf(*parseFormat(text))); };
  EXPECT_EQ(nameOf("R(4, 4, 4) G(8)"), "r4_4_4_g8");
  EXPECT_EQ(nameOf("D(4^3, 6) M(2^3)"), "d4_4_4_6_m2_2_2");
  EXPECT_TRUE(isHeaderName(nameOf("G(4, 2)")));
  EXPECT_TRUE(isHeaderName("Bunny_2"));
  for (const char *name : {"", "_a", "a_", "a__b", "a b", "a-b"})
    EXPECT_FALSE(isHeaderName(name)) << name;
}

} // namespace
} // namespace voxc
