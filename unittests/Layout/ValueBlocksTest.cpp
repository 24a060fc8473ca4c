// Blocks of values: what goes in comes out, in few words; what is broken is found.
#include "voxc/Layout/ValueBlocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

namespace voxc {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << kLog2ValueBlock;

/// The section of some values, behind words that are not its own.
std::vector<std::uint32_t> sectionOf(const std::vector<std::uint32_t> &values, std::size_t before) {
  std::vector<std::uint32_t> words(before, 0xabad1dea);
  std::vector<std::uint32_t> blocks;
  const std::size_t count = (values.size() + kBlock - 1) / kBlock;
  for (std::size_t i = 0; i < count; ++i) {
    words.push_back(static_cast<std::uint32_t>(count + blocks.size()));
    const std::size_t size = std::min(kBlock, values.size() - i * kBlock);
    const auto block = encodeValueBlock(std::span(values).subspan(i * kBlock, size));
    blocks.insert(blocks.end(), block.begin(), block.end());
  }
  words.insert(words.end(), blocks.begin(), blocks.end());
  words.push_back(0);
  return words;
}

using MakeValue = std::function<std::uint32_t(std::mt19937 &random, std::uint32_t last)>;

void expectRoundTrip(const MakeValue &make, std::size_t count) {
  std::mt19937 random(static_cast<unsigned>(count));
  std::vector<std::uint32_t> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(make(random, values.empty() ? 0 : values.back()));
  const auto words = sectionOf(values, 3);
  WordReader reader(words);
  checkValues(reader, 3, count, true);
  EXPECT_FALSE(reader.problem()) << *reader.problem();
  for (std::size_t i = 0; i < count; ++i)
    ASSERT_EQ(valueOfRank(reader, 3, i), values[i]) << "value " << i << " of " << count;
}

std::uint32_t anyWord(std::mt19937 &random, std::uint32_t) { return static_cast<std::uint32_t>(random()); }
std::uint32_t ofFew(std::mt19937 &random, std::uint32_t) { return 0xff000000u | (random() % 5) * 0x010305u; }
std::uint32_t inRuns(std::mt19937 &random, std::uint32_t last) {
  return random() % 8 == 0 ? static_cast<std::uint32_t>(random()) : last;
}
std::uint32_t inRunsOfFew(std::mt19937 &random, std::uint32_t last) {
  return random() % 8 == 0 ? ofFew(random, last) : last;
}
/// R and B follow G, so that differences take fewer bits; some wrap.
std::uint32_t grey(std::mt19937 &random, std::uint32_t) {
  const std::uint32_t g = random() % 256;
  const auto near = [&] { return std::min(g + random() % 3, std::uint_fast32_t{255}); };
  return static_cast<std::uint32_t>(near() | g << 8 | near() << 16 | 0xff000000u);
}
std::uint32_t ofOneColour(std::mt19937 &, std::uint32_t) { return 0x12345678; }
std::uint32_t extremes(std::mt19937 &random, std::uint32_t) {
  return (random() % 2 * 255u) | (random() % 2 * 255u) << 8 | (random() % 2 * 255u) << 16;
}

TEST(ValueBlocks, ComeBackAsTheyWere) {
  for (const MakeValue make : {anyWord, ofFew, inRuns, inRunsOfFew, grey, ofOneColour, extremes})
    for (const std::size_t count : {1, 2, 31, 32, 33, 127, 128, 129, 1000})
      expectRoundTrip(make, count);
}

TEST(ValueBlocks, HaveNoValueThatIsNoVoxel) {
  for (const MakeValue make : {anyWord, ofFew, inRuns, inRunsOfFew, extremes}) {
    std::mt19937 random(4);
    std::vector<std::uint32_t> values;
    for (std::size_t i = 0; i < 300; ++i)
      values.push_back(make(random, values.empty() ? 1 : values.back()) | 0x100);
    for (const bool hasZero : {false, true}) {
      if (hasZero)
        values[200] = 0;
      const auto words = sectionOf(values, 3);
      WordReader reader(words);
      checkValues(reader, 3, values.size(), false);
      EXPECT_EQ(reader.problem().has_value(), hasZero);
    }
  }
}

TEST(ValueBlocks, TakeFewWords) {
  const auto words = [](const MakeValue &make) {
    std::mt19937 random(1);
    std::vector<std::uint32_t> values(kBlock);
    for (std::size_t i = 0; i < kBlock; ++i)
      values[i] = make(random, i == 0 ? 0 : values[i - 1]);
    return encodeValueBlock(values).size();
  };
  EXPECT_EQ(words(ofOneColour), 2u);
  EXPECT_LE(words(anyWord), 2u + 128u);
  EXPECT_LE(words(ofFew), 2u + 12u + 3u);       // 3 bits each, and a palette of five.
  EXPECT_LE(words(grey), 2u + 48u);             // 8 + 2 + 2 bits each.
  EXPECT_LE(words(inRuns), 2u + 4u + 128u / 4); // A bit each, and about 16 runs.
  EXPECT_LE(words(inRunsOfFew), 2u + 4u + 3u + 3u);
}

/// Whatever a file holds, checking and decoding end, and nothing outside of the words is touched.
TEST(ValueBlocks, BrokenOnesAreFound) {
  std::mt19937 random(7);
  std::vector<std::uint32_t> values(300);
  for (std::uint32_t &value : values)
    value = inRunsOfFew(random, value);
  const auto whole = sectionOf(values, 1);
  unsigned found = 0;
  for (int round = 0; round < 2000; ++round) {
    auto words = whole;
    if (round % 2 == 0)
      words[1 + random() % (words.size() - 1)] ^= 1u << random() % 32;
    else
      words.resize(1 + random() % (words.size() - 1));
    WordReader reader(words);
    checkValues(reader, 1, values.size(), false);
    found += reader.problem() ? 1 : 0;
    EXPECT_TRUE(reader.problem() || round % 2 == 0) << "words were cut off";
    for (std::size_t i = 0; i < values.size(); ++i)
      valueOfRank(reader, 1, i);
  }
  EXPECT_GT(found, 1000u);
}

} // namespace
} // namespace voxc
