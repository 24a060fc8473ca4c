// Blocks of indices and their table: what goes in comes out, in few words; what is broken is found.
#include "voxc/Layout/PaletteBlocks.h"
#include "voxc/Layout/ValueBlocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

namespace voxc {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << kLog2ValueBlock;

std::uint32_t colourOf(std::uint32_t index) { return 0xff000000u | index * 0x000305u; }

/// The section of the colours of some indices, behind words that are not its own.
std::vector<std::uint32_t> sectionOf(const std::vector<std::uint32_t> &indices, std::size_t before) {
  std::vector<std::uint32_t> colours;
  for (std::uint32_t i = 0; i <= *std::ranges::max_element(indices); ++i)
    colours.push_back(colourOf(i));
  std::vector<std::uint32_t> blocks;
  std::vector<std::uint32_t> entries;
  const std::size_t count = (indices.size() + kBlock - 1) / kBlock;
  for (std::size_t i = 0; i < count; ++i) {
    const auto block = std::span(indices).subspan(i * kBlock, std::min(kBlock, indices.size() - i * kBlock));
    const bool isPlain = std::ranges::adjacent_find(block, std::not_equal_to()) == block.end();
    entries.push_back(isPlain ? block[0] : static_cast<std::uint32_t>(kMostPaletteColours + blocks.size()));
    const auto encoded = encodeIndexBlock(block);
    if (!isPlain)
      blocks.insert(blocks.end(), encoded.begin(), encoded.end());
  }
  const int bits = entryBitsOf(colours.size(), count, blocks.size());
  const std::size_t tableWords = (count * static_cast<std::size_t>(bits) + 31) / 32;
  for (std::uint32_t &entry : entries)
    entry = static_cast<std::uint32_t>(1 + (entry < kMostPaletteColours
                                                ? entry
                                                : entry - kMostPaletteColours + colours.size() + tableWords));
  entries.resize(packEntries(entries, bits));
  std::vector<std::uint32_t> words(before, 0xabad1dea);
  for (const auto &part : {paletteHead(colours, bits), entries, blocks, std::vector<std::uint32_t>{0}})
    words.insert(words.end(), part.begin(), part.end());
  return words;
}

using MakeIndex = std::function<std::uint32_t(std::mt19937 &random, std::uint32_t last)>;

std::vector<std::uint32_t> indicesOf(const MakeIndex &make, std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i < count; ++i)
    indices.push_back(make(random, indices.empty() ? 0 : indices.back()));
  return indices;
}

void expectRoundTrip(const MakeIndex &make, std::size_t count) {
  const auto indices = indicesOf(make, count, static_cast<unsigned>(count));
  const auto words = sectionOf(indices, 3);
  WordReader reader(words);
  checkPalette(reader, 3, count, kMostPaletteColours);
  EXPECT_FALSE(reader.problem()) << *reader.problem();
  for (std::size_t i = 0; i < count; ++i)
    ASSERT_EQ(colourOfRank(reader, 3, i), colourOf(indices[i])) << "value " << i << " of " << count;
}

template <unsigned Colours> std::uint32_t anyOf(std::mt19937 &random, std::uint32_t) {
  return static_cast<std::uint32_t>(random() % Colours);
}
template <unsigned Mean, unsigned Colours> std::uint32_t inRuns(std::mt19937 &random, std::uint32_t last) {
  return random() % Mean == 0 ? anyOf<Colours>(random, last) : last;
}
/// Few of many colours in each block, far from each other.
std::uint32_t ofTwoFarOnes(std::mt19937 &random, std::uint32_t) { return random() % 2 * 60000; }
std::uint32_t ofOneColour(std::mt19937 &, std::uint32_t) { return 5; }

TEST(PaletteBlocks, ComeBackAsTheyWere) {
  for (const MakeIndex make : {anyOf<2>, anyOf<5>, anyOf<300>, anyOf<65536>, inRuns<8, 5>, inRuns<30, 5>,
                               inRuns<60, 40000>, inRuns<4, 9>, ofTwoFarOnes, ofOneColour})
    for (const std::size_t count : {1, 2, 31, 32, 33, 127, 128, 129, 1000})
      expectRoundTrip(make, count);
}

TEST(PaletteBlocks, TakeFewWords) {
  const auto words = [](const MakeIndex &make) {
    return encodeIndexBlock(indicesOf(make, kBlock, 1)).size();
  };
  EXPECT_EQ(words(ofOneColour), 1u);
  EXPECT_EQ(words(anyOf<2>), 1u + 4u);
  EXPECT_LE(words(anyOf<65536>), 1u + 64u);
  EXPECT_EQ(words(ofTwoFarOnes), 1u + 5u);      // A bit each, and a palette of two.
  EXPECT_LE(words(inRuns<30, 5>), 1u + 2u);     // About five runs: a begin and an item each.
  EXPECT_LE(words(inRuns<4, 9>), 1u + 4u + 4u); // A bit each, and about 30 runs.
}

/// Blocks of one colour take an entry in the table, and no more.
TEST(PaletteBlocks, OfOneColourAreEntries) {
  const auto words = sectionOf(std::vector<std::uint32_t>(100 * kBlock, 0), 0);
  EXPECT_EQ(words.size(), 1u + 1u + 4u + 1u); // A bit each.
}

TEST(PaletteBlocks, MoreColoursThanStatedAreFound) {
  const auto words = sectionOf({0, 1, 2, 3, 4}, 1);
  WordReader four(words);
  checkPalette(four, 1, 5, 4);
  EXPECT_TRUE(four.problem());
  WordReader eight(words);
  checkPalette(eight, 1, 5, 8);
  EXPECT_FALSE(eight.problem());
}

/// Whatever a file holds, checking and decoding end, and nothing outside of the words is touched. What passes
/// the check has colours of the table alone.
TEST(PaletteBlocks, BrokenOnesAreFound) {
  std::mt19937 random(7);
  unsigned found = 0;
  for (const MakeIndex make : {anyOf<5>, inRuns<8, 5>, inRuns<30, 5>, ofTwoFarOnes}) {
    const auto indices = indicesOf(make, 300, 9);
    const auto whole = sectionOf(indices, 1);
    const WordReader original(whole);
    const std::uint64_t colours = paletteColours(original, 1);
    for (int round = 0; round < 2000; ++round) {
      auto words = whole;
      const std::uint64_t behindColours = 2 + colours;
      if (round % 2 == 0)
        words[behindColours + random() % (words.size() - behindColours)] ^= 1u << random() % 32;
      else
        words.resize(1 + random() % (words.size() - 1));
      WordReader reader(words);
      checkPalette(reader, 1, indices.size(), kMostPaletteColours);
      found += reader.problem() ? 1 : 0;
      EXPECT_TRUE(reader.problem() || round % 2 == 0) << "words were cut off";
      for (std::size_t i = 0; i < indices.size(); ++i) {
        const std::uint32_t colour = colourOfRank(reader, 1, i);
        EXPECT_TRUE(reader.problem() ||
                    std::ranges::count(std::span(whole).subspan(2, colours), colour) == 1);
      }
    }
  }
  EXPECT_GT(found, 4000u);
}

} // namespace
} // namespace voxc
