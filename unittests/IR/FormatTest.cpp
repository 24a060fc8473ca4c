// Parsing, printing and verifying of formats.
#include "voxc/IR/Format.h"
#include "testing/RandomFormat.h"
#include "voxc/IR/Limits.h"
#include "voxc/IR/Query.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace voxc {
namespace {

using ::testing::HasSubstr;

std::string errorOf(std::string_view text) {
  const auto format = parseFormat(text);
  return format ? "no error" : format.error().message;
}

TEST(Format, KnowsItsSizes) {
  const Format format = *parseFormat("R(1,0,2) D(2,2,2,4)");
  EXPECT_EQ(format.extent(), (Int3{8, 4, 16}));
  EXPECT_EQ(format.log2CellSide(0), 2);
  EXPECT_EQ(format.log2CellSide(1), 0);
  EXPECT_EQ(format.levels[1].parameter(ParameterRole::Reach), 4u);
}

TEST(Format, TakesBlanksAnywhereAndCubes) {
  const Format spread = *parseFormat(" R ( 4 , 4\t, 4 )\nG(8) ");
  EXPECT_EQ(spread, *parseFormat("R(4^3)G(8)"));
  EXPECT_EQ(spread, *parseFormat("R(4 ^ 3) G(8)"));
  EXPECT_EQ(toString(spread), "R(4, 4, 4) G(8)");
}

TEST(Format, ReportsEveryErrorOfAString) {
  Diagnostics diagnostics;
  parseFormat("Q(1) R(4,4) D(4^3,0) S(x)", diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 4u);
  EXPECT_EQ(diagnostics.all()[0].range, (SourceRange{0, 1}));
  EXPECT_EQ(diagnostics.all()[1].range, (SourceRange{5, 11}));
  EXPECT_EQ(diagnostics.all()[2].range, (SourceRange{18, 19}));
  EXPECT_EQ(diagnostics.all()[3].range, (SourceRange{23, 24}));
}

TEST(Format, RefusesWhatNoVolumeCanHold) {
  EXPECT_THAT(errorOf("R(11,11,11)"), HasSubstr("2^33 words"));
  EXPECT_THAT(errorOf("D(11,10,10,3)"), HasSubstr("2^32 words"));
  EXPECT_THAT(errorOf("S(11) G(11)"), HasSubstr("at most 2^21"));
  EXPECT_EQ(errorOf("R(20,0,0)"), "no error");
  EXPECT_EQ(errorOf("S(21)"), "no error");
}

/// Sets the limit back.
struct DefaultLevels {
  ~DefaultLevels() { allowLevels(kDefaultLevels); }
};

std::string levelsOf(std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
    text += "G(0) ";
  return text;
}

TEST(Format, HasAsManyLevelsAsTheProcessAllows) {
  const DefaultLevels after;
  EXPECT_TRUE(parseFormat(levelsOf(kDefaultLevels)));
  const auto refused = parseFormat(levelsOf(kDefaultLevels + 1));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("has 22 levels; it may have at most 21, or up to 64 where "
                                                 "VOXC_MAX_LEVELS allows so many"));
  allowLevels(1000);
  EXPECT_TRUE(parseFormat(levelsOf(kMostLevels)));
  const auto never = parseFormat(levelsOf(kMostLevels + 1));
  ASSERT_FALSE(never);
  EXPECT_THAT(never.error().message, HasSubstr("it may have at most 64\n"));
}

/// What a text is wrong in takes time and room that follow its size: a head of a .hvx file may have 2^20
/// bytes.
TEST(Format, TellsOfALongTextInFewWords) {
  std::string words;
  for (int i = 0; i < 1 << 19; ++i)
    words += "x ";
  const std::string texts[] = {words, std::string(1 << 20, '('), std::string(1 << 20, 'x'),
                               "format { level 1: raw(1,1,1) " + words + "}", levelsOf(1 << 17)};
  for (const std::string &text : texts) {
    const auto parsed = parseFormat(text);
    ASSERT_FALSE(parsed);
    EXPECT_LT(parsed.error().message.size(), 100000u);
  }
}

TEST(Format, ShowsTheRightSpellingOfCounts) {
  EXPECT_THAT(errorOf("Raw(16,16,16)"), HasSubstr("write R(4, 4, 4)"));
  EXPECT_THAT(errorOf("DF(16,16,16,6)"), HasSubstr("write D(4, 4, 4, 6)"));
  EXPECT_THAT(errorOf("R(16,16,16)"), HasSubstr("16 cells are written 4"));
}

TEST(Format, KeepsAttributesInOneOrder) {
  Format one = *parseFormat("R(1^3) G(2)");
  Format other = one;
  one.levels[1].setAttribute(kDedupAttribute, "level");
  one.levels[1].setAttribute(kTraversalAttribute, "restart");
  other.levels[1].setAttribute(kTraversalAttribute, "restart");
  other.levels[1].setAttribute(kDedupAttribute, "level");
  EXPECT_EQ(one, other);
  EXPECT_FALSE(one.levels[0].setAttribute(kDedupAttribute, "level")) << "a raw grid has no such attribute";
  EXPECT_EQ(storageFormat(one).levels[1].attribute(kTraversalAttribute), "stack");
  EXPECT_EQ(storageFormat(one).levels[1].attribute(kDedupAttribute), "level");
  EXPECT_EQ(storageDigest(one), storageDigest(storageFormat(one)));
  EXPECT_NE(storageDigest(one), storageDigest(*parseFormat("R(1^3) G(2)")));
}

TEST(Ir, AFormatHasAttributesOfItsOwn) {
  Format format = *parseFormat("format precision=fast { level 1: raw(2, 2, 2) }");
  EXPECT_EQ(format.attributes.value(kPrecisionAttribute), "fast");
  EXPECT_EQ(printIr(format), "format precision=fast {\n  level 1: raw(2, 2, 2)\n}\n");
  EXPECT_EQ(storageDigest(format), storageDigest(*parseFormat("R(2^3)")));
  EXPECT_TRUE(format.setAttribute(kPrecisionAttribute, "exact"));
  EXPECT_EQ(format, *parseFormat("R(2^3)"));
  EXPECT_FALSE(format.setAttribute(kTraversalAttribute, "restart")) << "an attribute of levels";
}

TEST(Ir, SaysWhatIsAskedOfAKernel) {
  EXPECT_EQ(questionOf(*parseFormat("R(2^3)")), Question{});
  const auto asked = parseFormat("format query=distance { level 1: raw(2, 2, 2) }");
  EXPECT_EQ(questionOf(*asked), (Question{Query::Distance, {.voxel = false, .colour = false}}));
  const auto chosen = parseFormat("format voxel=no face=yes { level 1: raw(2, 2, 2) }");
  EXPECT_EQ(questionOf(*chosen), (Question{Query::Closest, {.voxel = false, .face = true}}));
  EXPECT_EQ(storageDigest(*chosen), storageDigest(*parseFormat("R(2^3)")));
  EXPECT_TRUE(parseFormat("format query=distance voxel=no { level 1: raw(2, 2, 2) }")) << "as it is anyway";
  EXPECT_FALSE(parseFormat("format query=any face=yes { level 1: raw(2, 2, 2) }"));
  EXPECT_FALSE(parseFormat("format voxel=no t=no colour=no { level 1: raw(2, 2, 2) }"));
}

TEST(Ir, RefusesValuesThatAnAttributeLacks) {
  Format format = *parseFormat("format precision=fast { level 1: svdag(2) traversal=restart }");
  const Format before = format;
  EXPECT_FALSE(format.levels[0].setAttribute(kTraversalAttribute, "level")) << "a value of another attribute";
  EXPECT_FALSE(format.levels[0].setAttribute(kDedupAttribute, ""));
  EXPECT_FALSE(format.setAttribute(kPrecisionAttribute, "exactly"));
  EXPECT_EQ(format, before);
}

TEST(Ir, RoundTripsRandomFormats) {
  std::mt19937 random(20260101);
  for (int i = 0; i < 2000; ++i) {
    const Format format = test::randomFormat(random, test::pick(random, 0, 9));
    const std::string text = printIr(format);
    const auto parsed = parseFormat(text);
    ASSERT_TRUE(parsed) << parsed.error().message;
    ASSERT_EQ(*parsed, format) << text;
    ASSERT_EQ(printIr(*parsed), text);
  }
}

TEST(Ir, DropsDefaultsAndComments) {
  const auto parsed =
      parseFormat("format { // two levels\n level 1: svo(3) traversal=stack level 2: raw(1,1,1)\n}");
  ASSERT_TRUE(parsed) << parsed.error().message;
  EXPECT_EQ(printIr(*parsed), "format {\n  level 1: svo(3)\n  level 2: raw(1, 1, 1)\n}\n");
}

TEST(Ir, RefusesWhatItDoesNotKnow) {
  EXPECT_THAT(errorOf("format { level 1: raw(1,1,1) traversal=restart }"), HasSubstr("it has share"));
  EXPECT_THAT(errorOf("format { level 1: svdag(3) traversal=up }"), HasSubstr("it takes stack, restart"));
  EXPECT_THAT(errorOf("format { level 2: svdag(3) }"), HasSubstr("level 1 should be"));
  EXPECT_THAT(errorOf("format { level 1: tree(3) }"), HasSubstr("raw, distance, svo, svdag"));
  EXPECT_THAT(errorOf("format { }"), HasSubstr("no level"));
  EXPECT_THAT(errorOf("format { level 1: svo(3)"), HasSubstr("the end"));
  EXPECT_THAT(errorOf("format { level 1: svo(3) } x"), HasSubstr("after the format's '}'"));
}

/// Both grammars, which share the limit.
TEST(Ir, HasAtMostAMebibyteOfText) {
  const std::string blanks(std::size_t{1} << 20, ' ');
  for (const std::string text : {"G(3)", "format { level 1: svo(3) }"}) {
    EXPECT_TRUE(parseFormat(text + blanks.substr(text.size())));
    EXPECT_THAT(errorOf(text + blanks), HasSubstr("that of a format has at most 1048576"));
  }
}

TEST(Ir, SurvivesEveryPrefixAndEveryChangedCharacter) {
  const std::string text = "format {\n  level 1: distance(2, 2, 2, 6)\n  level 2: svdag(3) dedup=level\n}\n";
  for (std::size_t length = 0; length <= text.size(); ++length)
    (void)parseFormat(text.substr(0, length));
  for (std::size_t at = 0; at < text.size(); ++at)
    for (int c = 0; c < 256; ++c) {
      std::string changed = text;
      changed[at] = static_cast<char>(c);
      Diagnostics diagnostics;
      parseIr(changed, diagnostics);
      render(diagnostics, changed, "changed");
    }
}

} // namespace
} // namespace voxc
