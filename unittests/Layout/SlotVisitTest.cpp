// Visits of nodes beside the look-up of each child: the same children, in Morton order, and as many as a node
// of the lowest layer counts.
#include "voxc/IR/Format.h"
#include "voxc/Layout/Layout.h"
#include "voxc/Layout/SlotKind.h"
#include "voxc/Layout/SubVolume.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace voxc {
namespace {

/// The words of a node with a child at about every third place, each leading to a word that is not 0.
std::vector<std::uint32_t> randomNode(std::mt19937 &random, std::uint64_t maskWords) {
  std::vector<std::uint32_t> words = {1, 1};
  for (std::uint64_t i = 0; i < maskWords; ++i)
    words.push_back(random() & (random() | random()));
  for (int i = 0; i < 64; ++i)
    words.push_back(1 + random() % 60);
  return words;
}

struct Case {
  const char *format;
  std::size_t level;       ///< Of the node, from 0.
  std::uint64_t maskWords; ///< At its beginning.
};

bool isInside(Int3 log2Shape, Int3 place) {
  return (place.x >> log2Shape.x | place.y >> log2Shape.y | place.z >> log2Shape.z) == 0;
}

class SlotVisit : public testing::TestWithParam<Case> {};

TEST_P(SlotVisit, TellsWhatLookUpsTell) {
  const Layout layout = layoutOf(*parseFormat(GetParam().format));
  const Stratum &stratum = layout.strata[GetParam().level];
  const SlotKind &slots = *stratum.slots;
  const int side = 1 << maxComponent(stratum.log2Shape);
  std::mt19937 random(1);
  constexpr std::uint64_t kNode = 2;
  for (int run = 0; run < 200; ++run) {
    const auto words = randomNode(random, GetParam().maskWords);
    WordReader reader(words);
    std::vector<std::uint64_t> expected;
    for (std::uint64_t code = 0; code < static_cast<std::uint64_t>(side) * side * side; ++code)
      if (const Int3 place = mortonCell(code);
          isInside(stratum.log2Shape, place) && slots.child(reader, stratum, kNode, place).exists)
        expected.push_back(code);
    std::vector<std::uint64_t> visited;
    slots.visit(reader, stratum, kNode, [&](Int3 place, const Child &child) {
      visited.push_back(mortonCode(place));
      const Child found = slots.child(reader, stratum, kNode, place);
      EXPECT_TRUE(child.exists);
      EXPECT_EQ(child.leaf, found.leaf);
      EXPECT_EQ(child.at, found.at);
    });
    EXPECT_EQ(visited, expected);
    // Nodes that a check refuses, such as those of leaves that are empty, are not counted.
    const std::uint64_t count = slots.count(reader, stratum, kNode, 1);
    EXPECT_TRUE(reader.problem() || count == expected.size()) << count;
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, SlotVisit,
                         testing::Values(Case{"R(2^3) M(2^3)", 1, 2}, Case{"M(2^3) R(2^3)", 0, 2},
                                         Case{"M(1,2,1) R(2^3)", 0, 1}, Case{"M(2,1,0) R(2^3)", 0, 1},
                                         Case{"G(3)", 0, 1}, Case{"R(2^3)", 0, 0}),
                         [](const auto &test) { return "number" + std::to_string(test.index); });

} // namespace
} // namespace voxc
