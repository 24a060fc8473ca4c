// The empty cubes that a D level tells by octant are the largest there are, and all of them are empty.
#include "testing/HardScenes.h"
#include "voxc/Construct/Constructor.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace voxc {
namespace {

/// A D level alone, 8 cells a side, with octants beside the values.
Format octantFormat(const char *text) {
  Format format = *parseFormat(text);
  for (Level &level : format.levels)
    level.setAttribute(kMetricAttribute, "octant");
  return format;
}

bool isEmptyCube(const Volume &volume, Int3 low, Int3 extent) {
  for (Int3 c; c.z < extent.z; ++c.z)
    for (c.y = 0; c.y < extent.y; ++c.y)
      for (c.x = 0; c.x < extent.x; ++c.x)
        if (volume.lookup(low + c).value != 0)
          return false;
  return true;
}

/// The largest empty cube of cells from `cell` in the direction of an octant, within `least` to `most` cells;
/// what lies outside of them is empty, or full.
std::uint32_t largestCube(const Volume &volume, Int3 cell, int octant, Int3 extent, bool outsideIsEmpty) {
  constexpr int kMost = 15;
  for (int side = kMost; side > 1; --side) {
    Int3 low;
    Int3 high;
    bool leaves = false;
    for (int axis = 0; axis < 3; ++axis) {
      const bool rises = (octant >> axis & 1) != 0;
      low[axis] = rises ? cell[axis] : cell[axis] - side + 1;
      high[axis] = low[axis] + side;
      leaves |= low[axis] < 0 || high[axis] > extent[axis];
      low[axis] = std::max(low[axis], 0);
      high[axis] = std::min(high[axis], extent[axis]);
    }
    if ((!leaves || outsideIsEmpty) && isEmptyCube(volume, low, high - low))
      return static_cast<std::uint32_t>(side);
  }
  return 1;
}

/// Checks the fields of a grid of 8 cells a side, whose slots of two words begin at `grid`.
void expectLargest(const Volume &volume, std::uint32_t grid, Int3 low, bool outsideIsEmpty) {
  constexpr int kSide = 8;
  for (Int3 c; c.z < kSide; ++c.z)
    for (c.y = 0; c.y < kSide; ++c.y)
      for (c.x = 0; c.x < kSide; ++c.x) {
        const auto slot = grid + 2 * static_cast<std::uint32_t>(c.x + kSide * (c.y + kSide * c.z));
        for (int octant = 0; octant < 8; ++octant) {
          const std::uint32_t told = volume.words()[slot + 1] >> 4 * octant & 15;
          const bool full = volume.words()[slot] != 0;
          ASSERT_EQ(told, full ? 0
                               : largestCube(volume, low + c, octant, low + Int3{kSide, kSide, kSide},
                                             outsideIsEmpty))
              << c.x << "," << c.y << "," << c.z << " octant " << octant;
        }
      }
}

TEST(Octants, AreTheLargestEmptyCubes) {
  const auto constructor = Constructor::compile(octantFormat("D(3^3, 15)"));
  ASSERT_TRUE(constructor);
  for (const test::HardScene &scene : test::hardScenes({8, 8, 8})) {
    const auto source = scene.source();
    const auto built = constructor->build(*source);
    ASSERT_TRUE(built);
    if (built->volume.words()[0] != 0)
      expectLargest(built->volume, built->volume.words()[0], {}, true);
  }
}

TEST(Octants, StayInTheirSubVolumeBelowAnotherLevel) {
  const auto constructor = Constructor::compile(octantFormat("R(0, 0, 0) D(3^3, 15)"));
  ASSERT_TRUE(constructor);
  for (const test::HardScene &scene : test::hardScenes({8, 8, 8})) {
    const auto source = scene.source();
    const auto built = constructor->build(*source);
    ASSERT_TRUE(built);
    const auto words = built->volume.words();
    if (words[0] != 0)
      expectLargest(built->volume, words[words[0]], {}, false);
  }
}

} // namespace
} // namespace voxc
