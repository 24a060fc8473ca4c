// Random formats: what property tests see of the formats there are.
#include "testing/RandomFormat.h"

#include "voxc/IR/Stack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string_view>

namespace voxc::test {
namespace {

/// How many of so many random formats with trees have each traversal.
std::map<std::string_view, int> countTraversals(int formats) {
  std::map<std::string_view, int> counts;
  std::mt19937 random(1);
  for (int found = 0; found < formats;) {
    const Format format = randomFormat(random, pick(random, 3, 7));
    const auto tree = std::ranges::find_if(
        format.levels, [](const Level &level) { return level.parameter(ParameterRole::Side) > 0; });
    if (tree == format.levels.end())
      continue;
    const std::string_view levels = format.attributes.value(kLevelsAttribute);
    ++counts[levels != "auto" ? levels : tree->attribute(kTraversalAttribute)];
    ++found;
  }
  return counts;
}

TEST(RandomFormats, HaveEveryTraversalEquallyOften) {
  constexpr int kFormats = 3000;
  const auto counts = countTraversals(kFormats);
  // That of a tree counts where `levels` is `auto`.
  const std::size_t traversals = kTraversalAttribute.values.size() + kLevelsAttribute.values.size() - 1;
  ASSERT_EQ(counts.size(), traversals);
  const int share = kFormats / static_cast<int>(traversals);
  for (const auto &[traversal, count] : counts)
    EXPECT_NEAR(count, share, share / 10) << traversal;
}

TEST(RandomFormats, HaveSharedStacksHalfOfTheTime) {
  constexpr int kFormats = 1000;
  int shared = 0;
  std::mt19937 random(2);
  for (int found = 0; found < kFormats;) {
    const Format format = randomFormat(random, pick(random, 3, 7));
    if (format.attributes.value(kLevelsAttribute) == "flat") { // Which keeps nodes, whatever the levels are.
      shared += format.attributes.value(kStackAttribute) == "shared";
      ++found;
    }
  }
  EXPECT_NEAR(shared, kFormats / 2, kFormats / 10);
}

} // namespace
} // namespace voxc::test
