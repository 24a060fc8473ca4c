// Cropping: the same voxels, moved to the corner of an extent that fits them.
#include "voxc/Source/Crop.h"
#include "FloodTesting.h"
#include "TestLength.h"

#include "voxc/Source/Sources.h"

#include <atomic>

namespace voxc::test {
namespace {

/// A grid with voxels in [low, high) alone.
Grid gridWithin(Int3 extent, Int3 low, Int3 high, unsigned seed) {
  const Grid inner = hollowGrid(high - low, seed);
  Grid grid(extent);
  inner.forEach([&](Int3 cell) { grid.at(low + cell) = inner.at(cell); });
  // So that the box is this one.
  grid.at(low) = 3;
  grid.at(high - Int3{1, 1, 1}) = 4;
  return grid;
}

Voxels moved(const Grid &grid, Int3 low) {
  Voxels voxels;
  grid.forEach([&](Int3 cell) {
    if (grid.at(cell) != 0)
      voxels[mortonCode(cell - low)] = grid.at(cell);
  });
  return voxels;
}

TEST(Crop, MovesTheSmallestBoxToTheCorner) {
  std::mt19937 random(1);
  for (int round = 0; round < rounds(30); ++round) {
    Int3 extent;
    Int3 low;
    Int3 high;
    for (int axis = 0; axis < 3; ++axis) {
      extent[axis] = 1 + static_cast<int>(random() % 150);
      low[axis] = static_cast<int>(random() % static_cast<unsigned>(extent[axis]));
      high[axis] =
          low[axis] + 1 + static_cast<int>(random() % static_cast<unsigned>(extent[axis] - low[axis]));
    }
    const Grid grid = gridWithin(extent, low, high, static_cast<unsigned>(round));
    auto cropped = crop(makeGridSource(grid.extent, grid.words));
    ASSERT_TRUE(cropped) << cropped.error().message;
    EXPECT_EQ(cropped->low, low);
    EXPECT_EQ(cropped->source->extent(), high - low);
    const Voxels expected = moved(grid, low);
    ASSERT_EQ(voxelsOf(*cropped->source), expected);
    const auto view = cropped->source->view();
    cropped->source.reset();
    EXPECT_EQ(voxelsOf(*view), expected);
  }
}

TEST(Crop, OfVastAndEmptySources) {
  constexpr int kSide = 1 << kMaxLog2Extent;
  const Int3 corner{kSide - 3, 5, kSide / 2};
  const auto voxel = [corner](Int3 cell) -> std::uint32_t { return cell == corner ? 8 : 0; };
  const auto empty = [corner](const Cube &cube) {
    return (corner >> cube.log2Side) != (cube.low >> cube.log2Side);
  };
  auto one = crop(makeFunctionSource({kSide, kSide, kSide}, voxel, empty));
  ASSERT_TRUE(one);
  EXPECT_EQ(one->low, corner);
  EXPECT_EQ(voxelsOf(*one->source), (Voxels{{0, 8}}));
  auto none = crop(makeGridSource({20, 30, 40}, std::vector<std::uint32_t>(24000)));
  ASSERT_TRUE(none);
  EXPECT_EQ(none->low, Int3{});
  EXPECT_EQ(none->source->extent(), (Int3{1, 1, 1}));
  EXPECT_TRUE(voxelsOf(*none->source).empty());
}

TEST(Crop, KeepsPlacesInTheModel) {
  const Transform map = transformOfRows({2, 0, 0, 5, 0, 0, -3, 6, 0, 4, 0, 7});
  auto cropped = crop(makeSortedSource({90, 90, 90}, {{mortonCode({70, 30, 20}), 1}}, map));
  ASSERT_TRUE(cropped);
  EXPECT_EQ(cropped->low, (Int3{70, 30, 20}));
  const glm::dvec3 before = map * glm::dvec4(70.5, 30.25, 20.75, 1);
  const glm::dvec3 after = cropped->source->voxelToModel() * glm::dvec4(0.5, 0.25, 0.75, 1);
  EXPECT_EQ(before, after);
}

TEST(Crop, Stops) {
  std::atomic<bool> stop = true;
  Progress progress;
  progress.stop = &stop;
  const Grid grid = hollowGrid({130, 70, 70}, 2);
  const auto cropped = crop(makeGridSource(grid.extent, grid.words), progress);
  ASSERT_FALSE(cropped);
  EXPECT_EQ(cropped.error().kind, ErrorKind::Interrupted);
}

} // namespace
} // namespace voxc::test
