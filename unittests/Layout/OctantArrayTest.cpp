// Small grids by octants: what goes in comes out, in the words that are predicted; what is broken is found.
#include "voxc/Layout/OctantArray.h"
#include "voxc/Volume/Volume.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>
#include <vector>

namespace voxc {
namespace {

constexpr std::uint64_t kBefore = 3; // Words that are not the array's.

std::vector<std::uint32_t> arrayOf(const std::vector<std::uint32_t> &grids) {
  std::vector<std::uint32_t> words(kBefore, 0xffffffff);
  writeOctantArray(grids, [&](std::uint32_t word) { words.push_back(word); });
  return words;
}

/// Grids of few octants, of few cells.
std::vector<std::uint32_t> randomGrids(std::mt19937 &random, std::size_t count) {
  std::vector<std::uint32_t> grids;
  while (grids.size() < 2 * count) {
    std::uint64_t mask = 0;
    for (int octant = 0; octant < 8; ++octant)
      mask |= random() % 2 == 0 ? std::uint64_t{random() & random() & 0xff} << 8 * octant : 0;
    mask |= std::uint64_t{1} << random() % 64;
    grids.insert(grids.end(), {static_cast<std::uint32_t>(mask), static_cast<std::uint32_t>(mask >> 32)});
  }
  return grids;
}

TEST(OctantArray, GridsComeBack) {
  std::mt19937 random(1);
  for (const std::size_t count : {1, 3, 4, 5, 15, 16, 17, 33, 200}) {
    const auto grids = randomGrids(random, count);
    const auto words = arrayOf(grids);
    WordReader reader(words);
    std::uint64_t octants = 0;
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_TRUE(checkOctantGrid(reader, kBefore, i + 1, false)) << *reader.problem();
      const OctantGrid grid = octantGrid(reader, kBefore, i + 1);
      EXPECT_EQ(cellsOf(reader, grid), grids[2 * i] | std::uint64_t{grids[2 * i + 1]} << 32);
      octants += static_cast<std::uint64_t>(std::popcount(grid.octants));
    }
    EXPECT_EQ(words.size(), kBefore + octantArrayWords(count, octants));
    EXPECT_FALSE(reader.problem());
  }
  EXPECT_EQ(arrayOf({}).size(), kBefore);
}

TEST(OctantArray, WhatIsBrokenIsFound) {
  const std::vector<std::uint32_t> grids = {0x00000100, 0x80000000, 1, 0};
  const auto sound = arrayOf(grids); // A head of one word, the octants of two grids, three bytes of cells.
  ASSERT_EQ(sound.size(), kBefore + 3);
  EXPECT_EQ(sound[kBefore], 8u);
  EXPECT_EQ(sound[kBefore + 1], 0x0182u);
  EXPECT_EQ(sound[kBefore + 2], 0x018001u);
  const auto isSound = [](std::vector<std::uint32_t> words, std::uint64_t number, bool ranked = false) {
    WordReader reader(words);
    return checkOctantGrid(reader, kBefore, number, ranked);
  };
  EXPECT_TRUE(isSound(sound, 2));
  EXPECT_FALSE(isSound(sound, 2, true)) << "kernels count cells by two words";
  EXPECT_FALSE(isSound(sound, 3)) << "no octants";
  EXPECT_FALSE(isSound(sound, 17)) << "no head";
  const auto with = [&](std::size_t at, std::uint32_t word) {
    auto words = sound;
    words[kBefore + at] = word;
    return words;
  };
  EXPECT_FALSE(isSound(with(2, 0x010001), 1)) << "an octant of no cell";
  EXPECT_TRUE(isSound(with(2, 0x018001), 1));
  EXPECT_FALSE(isSound(with(0, 10), 1)) << "the last byte is outside";
  EXPECT_FALSE(isSound(with(0, 0xffffffff), 1)) << "farther than bits are told by a word";
}

TEST(OctantArray, VolumesAreProved) {
  const auto format = parseFormat("format payload=occupancy { level 1: masked(1, 1, 1) level 2: "
                                  "masked(2, 2, 2) pointers=16 masks=octants }");
  ASSERT_TRUE(format);
  // Root and array; a node of two children, both number 1; a grid of two voxels.
  const std::vector<std::uint32_t> sound = {2, 4, 3, 0x00010001, 8, 1, 3};
  const auto voxels = checkStructure(*format, sound);
  ASSERT_TRUE(voxels) << voxels.error().message;
  EXPECT_EQ(*voxels, 4u);
  for (const std::uint32_t number : {0u, 2u, 0xffffu}) {
    auto words = sound;
    words[3] = 0x00010000 | number;
    EXPECT_FALSE(checkStructure(*format, words)) << number;
  }
  std::mt19937 random(2); // No words, however wrong, lead outside: sanitizers see it.
  for (int i = 0; i < 2000; ++i) {
    auto words = sound;
    words[random() % words.size()] ^= 1u << random() % 32;
    (void)checkStructure(*format, words);
  }
}

} // namespace
} // namespace voxc
