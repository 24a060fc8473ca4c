// Which sentences follow from which facts.
#include "voxc/Facts/Recommendations.h"
#include "voxc/Facts/PointerChoice.h"

#include <gtest/gtest.h>

namespace voxc::test {
namespace {

/// The sentence of a rule, or "".
std::string sentence(const Facts &facts, std::string_view rule) {
  for (const Recommendation &recommendation : recommend(facts))
    if (recommendation.rule == rule)
      return recommendation.text;
  return "";
}

/// Facts of 1000 voxels that say nothing more of themselves.
Facts plainFacts() {
  Facts facts;
  facts.voxels = 1000;
  facts.heights.resize(4);
  facts.colours.opaque = 1000;
  facts.colours.words = {12, true};
  return facts;
}

TEST(Recommendations, NoVoxelsAreAllThatIsSaid) {
  const std::vector<Recommendation> recommendations = recommend({});
  ASSERT_EQ(recommendations.size(), 1u);
  EXPECT_EQ(recommendations[0].rule, "voxels");
}

TEST(Recommendations, Alpha) {
  Facts facts = plainFacts();
  EXPECT_TRUE(sentence(facts, "alpha").starts_with("All voxels are opaque"));
  facts.colours.opaque = 999;
  EXPECT_EQ(sentence(facts, "alpha"), "No voxel has an alpha of 0: --visible-voxels holds.");
  facts.colours.transparent = 1;
  EXPECT_TRUE(sentence(facts, "alpha").starts_with("Voxels with an alpha of 0: 1; a build"));
}

TEST(Recommendations, Colours) {
  Facts facts = plainFacts();
  EXPECT_TRUE(sentence(facts, "colours").starts_with("12 colours: an index into one palette takes 4 bits "));
  facts.colours.words = {1, true};
  EXPECT_TRUE(sentence(facts, "colours").starts_with("All voxels have one colour: --constant-colour"));
  facts.colours.words = {65537, false};
  facts.colours.perBlock8 = 17;
  EXPECT_EQ(sentence(facts, "colours"), "About 65537 colours: too many for one palette.");
  facts.colours.perBlock8 = 9.5;
  EXPECT_NE(sentence(facts, "colours").find("a block of 8^3 has 9.5 of them in the mean"), std::string::npos);
}

TEST(Recommendations, Box) {
  Facts facts = plainFacts();
  facts.log2Extent = 7;
  facts.boxLow = {10, 0, 3};
  facts.boxHigh = {20, 64, 4};
  EXPECT_EQ(sentence(facts, "box"),
            "The voxels lie in a box of 10 x 64 x 1: with --crop a cube of 2^6 holds them.");
  facts.boxHigh.y = 65;
  EXPECT_EQ(sentence(facts, "box"), "");
}

TEST(Recommendations, Interior) {
  Facts facts = plainFacts();
  facts.interior = 49;
  EXPECT_EQ(sentence(facts, "interior"), "4.9 % of the voxels are interior: nearly all touch an empty cell.");
  facts.interior = 100;
  EXPECT_EQ(sentence(facts, "interior"), "");
  facts.interior = 250;
  facts.heights[2].uniform = 5;
  EXPECT_EQ(sentence(facts, "interior"),
            "25.0 % of the voxels are interior, and 32.0 % lie in full cubes of 4^3 of "
            "one colour: trees (S, G) keep each as one leaf; --interior drop leaves out all that no ray from "
            "outside reaches.");
  facts.heights[2].uniform = 1;
  EXPECT_NE(sentence(facts, "interior").find("but only 6.4 % lie"), std::string::npos);
}

TEST(Recommendations, Repetition) {
  Facts facts = plainFacts();
  EXPECT_EQ(sentence(facts, "repetition"), "");
  facts.repetition = {{1, 0, {}, {}, {}}, {2, 0, {}, {}, {}}, {3, 100, {90, true}, {90, true}, {100, true}}};
  EXPECT_TRUE(
      sentence(facts, "repetition").starts_with("10.0 % of the blocks of 8^3 repeat another's shape: a DAG"));
  facts.repetition[2].shapes.count = 40;
  EXPECT_NE(sentence(facts, "repetition").find("but 0.0 % its colours too"), std::string::npos);
  facts.repetition[2].coloured.count = 60;
  EXPECT_TRUE(sentence(facts, "repetition")
                  .starts_with("40.0 % of the blocks of 8^3 repeat another with its colours"));
  facts.repetition[2].blocks = 63;
  EXPECT_EQ(sentence(facts, "repetition"), "");
}

TEST(Recommendations, Pointers) {
  Facts facts = plainFacts();
  EXPECT_EQ(sentence(facts, "pointers"), "");
  facts.repetition = {{1, 0, {}, {}, {}}, {2, 5000, {1023, true}, {}, {}}};
  EXPECT_EQ(sentence(facts, "pointers"), "The blocks of 4^3 have 1023 shapes: --short-pointers=10 numbers "
                                         "them, where M(2^3) is the last level.");
  facts.repetition[1].shapes.count = 1024; // Number 0 is none.
  EXPECT_NE(sentence(facts, "pointers").find("--short-pointers=11 "), std::string::npos);
  facts.repetition[1].shapes.count = 3;
  EXPECT_NE(sentence(facts, "pointers").find("--short-pointers=8 "), std::string::npos);
  facts.repetition[1].shapes = {1024, false};
  EXPECT_EQ(sentence(facts, "pointers"), "");
}

TEST(Recommendations, PointerBits) {
  Facts facts = plainFacts();
  EXPECT_EQ(choosePointerBits(facts), 8); // One block at most.
  facts.repetition = {{1, 0, {}, {}, {}}, {2, 5000, {255, true}, {}, {}}};
  EXPECT_EQ(choosePointerBits(facts), 8);
  facts.repetition[1].shapes.count = 256; // Number 0 is none.
  EXPECT_EQ(choosePointerBits(facts), 9);
  facts.repetition[1].shapes = {250'000, true};
  EXPECT_EQ(choosePointerBits(facts), 18);
  facts.repetition[1].shapes.exact = false; // It may be a few more than 2^18 - 1.
  EXPECT_EQ(choosePointerBits(facts), 19);
  facts.repetition[1].shapes = {(1 << 24) - 1, true};
  EXPECT_EQ(choosePointerBits(facts), 24);
  facts.repetition[1].shapes.count = 1 << 24;
  EXPECT_EQ(choosePointerBits(facts), std::nullopt);
}

} // namespace
} // namespace voxc::test
