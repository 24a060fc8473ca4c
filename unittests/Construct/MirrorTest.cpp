// A volume with mirror=yes has as many nodes as there are different ones but for reflections, and all voxels.
#include "voxc/Construct/Constructor.h"
#include "voxc/Passes/Pass.h"
#include "voxc/Source/Sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace voxc {
namespace {

constexpr int kLog2Side = 4;
constexpr int kSide = 1 << kLog2Side;

/// A cube of voxels, some of them full, x fastest.
using Cells = std::vector<std::uint32_t>;

std::size_t at(int side, Int3 c) { return static_cast<std::size_t>(c.x + side * (c.y + side * c.z)); }

/// Blocks of blocks, a few of them repeated and reflected, so that there is something to share.
Cells randomCells(std::mt19937 &random) {
  Cells cells(kSide * kSide * kSide);
  Cells block(64);
  for (std::uint32_t &cell : block)
    cell = random() % 3 == 0 ? kOccupied : 0;
  for (Int3 low; low.z < kSide; low.z += 4)
    for (low.y = 0; low.y < kSide; low.y += 4)
      for (low.x = 0; low.x < kSide; low.x += 4) {
        const Int3 flip = {static_cast<int>(random() % 2) * 3, static_cast<int>(random() % 2) * 3,
                           static_cast<int>(random() % 2) * 3};
        const bool isEmpty = random() % 4 == 0;
        for (Int3 c; c.z < 4; ++c.z)
          for (c.y = 0; c.y < 4; ++c.y)
            for (c.x = 0; c.x < 4; ++c.x)
              cells[at(kSide, low + c)] =
                  isEmpty ? 0 : block[at(4, {c.x ^ flip.x, c.y ^ flip.y, c.z ^ flip.z})];
      }
  return cells;
}

/// The cube of 2^log2Side at `low`, reflected across the axes whose bits are set.
Cells part(const Cells &cells, Int3 low, int side, unsigned reflection) {
  Cells taken(static_cast<std::size_t>(side) * side * side);
  const auto flip = [&](int place, unsigned axis) {
    return (reflection >> axis & 1) != 0 ? side - 1 - place : place;
  };
  for (Int3 c; c.z < side; ++c.z)
    for (c.y = 0; c.y < side; ++c.y)
      for (c.x = 0; c.x < side; ++c.x)
        taken[at(side, c)] = cells[at(kSide, low + Int3{flip(c.x, 0), flip(c.y, 1), flip(c.z, 2)})];
  return taken;
}

Cells leastReflection(const Cells &cells, Int3 low, int side) {
  Cells least = part(cells, low, side, 0);
  for (unsigned reflection = 1; reflection < 8; ++reflection)
    least = std::min(least, part(cells, low, side, reflection));
  return least;
}

/// The words of nodes that differ but for reflections: a mask, and a reference for each child that is neither
/// empty nor full.
std::uint64_t expectedWords(const Cells &cells) {
  std::uint64_t words = 1; // The root's reference.
  const auto isAll = [](const Cells &cube, std::uint32_t value) {
    return std::ranges::all_of(cube, [&](std::uint32_t cell) { return cell == value; });
  };
  for (int side = 2; side <= kSide; side *= 2) {
    std::set<Cells> known;
    for (Int3 low; low.z < kSide; low.z += side)
      for (low.y = 0; low.y < kSide; low.y += side)
        for (low.x = 0; low.x < kSide; low.x += side) {
          const Cells cube = part(cells, low, side, 0);
          if (isAll(cube, 0) || (side < kSide && isAll(cube, kOccupied)) ||
              !known.insert(leastReflection(cells, low, side)).second)
            continue;
          ++words;
          for (unsigned child = 0; child < 8; ++child) {
            const Int3 step = Int3{static_cast<int>(child & 1), static_cast<int>(child >> 1 & 1),
                                   static_cast<int>(child >> 2)} *
                              (side / 2);
            const Cells below = part(cells, low + step, side / 2, 0);
            words += isAll(below, 0) || isAll(below, kOccupied) ? 0 : 1;
          }
        }
  }
  return words;
}

Format mirroredFormat(const char *text) {
  Format format = *parseFormat(text);
  const std::vector<std::string> names = {"occupancy", "mirror", "whole-level-dedup"};
  EXPECT_TRUE(runPasses(format, names));
  EXPECT_TRUE(format.levels.back().get(kMirrorAttribute));
  return format;
}

Volume built(const Format &format, Int3 extent, const Cells &cells) {
  const auto constructor = Constructor::compile(format);
  auto result = constructor->build(*makeGridSource(extent, cells));
  EXPECT_TRUE(result);
  return std::move(result->volume);
}

TEST(Mirrored, SharesAllThatIsEqualButForReflections) {
  std::mt19937 random(44);
  for (int round = 0; round < 12; ++round) {
    const Cells cells = randomCells(random);
    const Volume volume = built(mirroredFormat("G(4)"), {kSide, kSide, kSide}, cells);
    EXPECT_EQ(volume.words().size(), expectedWords(cells));
    for (Int3 c; c.z < kSide; ++c.z)
      for (c.y = 0; c.y < kSide; ++c.y)
        for (c.x = 0; c.x < kSide; ++c.x)
          ASSERT_EQ(volume.lookup(c).value != 0, cells[at(kSide, c)] != 0) << c.x << "," << c.y << "," << c.z;
  }
}

TEST(Mirrored, HasOneRootForAVolumeAndItsReflection) {
  std::mt19937 random(45);
  const Cells cells = randomCells(random);
  Cells pair(2 * cells.size());
  for (Int3 c; c.z < kSide; ++c.z)
    for (c.y = 0; c.y < kSide; ++c.y)
      for (c.x = 0; c.x < 2 * kSide; ++c.x) {
        const int x = c.x < kSide ? c.x : 2 * kSide - 1 - c.x;
        pair[static_cast<std::size_t>(c.x + 2 * kSide * (c.y + kSide * c.z))] =
            cells[at(kSide, {x, c.y, c.z})];
      }
  const Volume one = built(mirroredFormat("R(0,0,0) G(4)"), {kSide, kSide, kSide}, cells);
  const Volume two = built(mirroredFormat("R(1,0,0) G(4)"), {2 * kSide, kSide, kSide}, pair);
  EXPECT_EQ(two.words().size(), one.words().size() + 1) << "one more cell of the grid";
}

} // namespace
} // namespace voxc
