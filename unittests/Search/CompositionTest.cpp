// The space of formats, and the rewrites that go through it.
#include "voxc/Search/Composition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <set>

namespace voxc {
namespace {

Composition compositionOf(const std::string &text) {
  const auto format = parseFormat(text);
  const auto composition = format ? voxc::compositionOf(*format) : std::nullopt;
  EXPECT_TRUE(composition) << text;
  return composition.value_or(Composition{});
}

TEST(Composition, ItsTextIsOfTheGrammar) {
  for (const char *text : {"R(4^3) G(5)", "D(3^3, 15) M(2^3) M(1^3)", "G(6, 2) S(3)", "H(5^3) S(4)"})
    EXPECT_EQ(toString(compositionOf(text)), text);
}

TEST(Composition, OtherShapesAreNone) {
  for (const char *text : {"R(4, 4, 3) G(5)", "D(3^3, 7) G(4)", "G(0) G(9)"})
    EXPECT_FALSE(voxc::compositionOf(*parseFormat(text))) << text;
}

TEST(Composition, RewritesKeepTheSide) {
  const Composition from = compositionOf("D(3^3, 15) G(4, 2) M(2^3)");
  const auto all = rewritesOf(from, 3);
  EXPECT_GT(all.size(), 20u);
  for (const Composition &to : all) {
    const auto format = parseFormat(toString(to));
    ASSERT_TRUE(format) << toString(to);
    EXPECT_EQ(maxComponent(format->log2Extent()), 9) << toString(to);
    EXPECT_LE(to.levels.size(), 3u) << toString(to);
    EXPECT_NE(to, from);
  }
}

TEST(Composition, EachKindOfRewriteIsThere) {
  const auto all = rewritesOf(compositionOf("R(4^3) G(5)"), 4);
  std::set<std::string> texts;
  for (const Composition &to : all)
    texts.insert(toString(to));
  for (const char *text : {"D(4^3, 15) G(5)", "R(4^3) M(5^3)", "R(1^3) R(3^3) G(5)", "R(4^3) G(2) M(3^3)",
                           "R(4^3) M(3^3) G(2)", "G(9)", "R(9^3)", "R(3^3) G(6)", "R(5^3) G(4)"})
    EXPECT_TRUE(texts.contains(text)) << text;
  for (const SmallGrids grids : {SmallGrids::Numbered, SmallGrids::ByOctants})
    EXPECT_TRUE(std::ranges::any_of(all, [&](const Composition &to) { return to.choices.grids == grids; }));
  EXPECT_TRUE(std::ranges::any_of(
      all, [](const Composition &to) { return to.choices.traversal == "direct-traversal"; }));
}

/// All of the space is within reach of any of it.
TEST(Composition, RewritesLeadEverywhere) {
  const auto reachable = [](const std::string &from) {
    std::set<std::string> texts;
    std::set<Composition> known;
    std::deque<Composition> open = {compositionOf(from)};
    while (!open.empty()) {
      for (Composition to : rewritesOf(open.front(), 3)) {
        to.choices = {};
        if (known.insert(to).second) {
          texts.insert(toString(to));
          open.push_back(to);
        }
      }
      open.pop_front();
    }
    return texts;
  };
  const auto texts = reachable("G(4)");
  EXPECT_EQ(texts, reachable("R(2^3) S(2)"));
  // Of 4 heights in one level, 4 of each tree's branchings and 4 of grids; and so on.
  EXPECT_TRUE(texts.contains("M(4^3)"));
  EXPECT_TRUE(texts.contains("H(3^3) R(1^3)"));
  EXPECT_TRUE(texts.contains("S(1) D(2^3, 15) G(1)"));
}

TEST(Composition, DifferencesAreCountedByHeight) {
  const Composition from = compositionOf("R(4^3) G(5)");
  EXPECT_EQ(differences(from, from), 0);
  EXPECT_EQ(differences(from, compositionOf("D(4^3, 15) G(5)")), 4);
  EXPECT_EQ(differences(from, compositionOf("R(2^3) R(2^3) G(5)")), 1);
  Composition traversed = from;
  traversed.choices.traversal = searchedTraversals()[1];
  EXPECT_GT(differences(from, traversed), 1);
}

} // namespace
} // namespace voxc
