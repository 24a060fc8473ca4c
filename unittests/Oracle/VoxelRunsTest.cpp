// Runs of voxels in Morton order: what is found where, and how much empty space around it.
#include "../../lib/Oracle/VoxelRuns.h"

#include <gtest/gtest.h>

namespace voxc::test {
namespace {

void expectEmpty(const VoxelRuns &runs, Int3 cell, Int3 low, int log2Side) {
  const std::optional<Cube> found = runs.emptyAround(cell);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->low, low);
  EXPECT_EQ(found->log2Side, log2Side);
  EXPECT_EQ(runs.word(cell), 0u);
}

void expectVoxel(const VoxelRuns &runs, Int3 cell, std::uint32_t word) {
  EXPECT_FALSE(runs.emptyAround(cell));
  EXPECT_EQ(runs.word(cell), word);
}

TEST(VoxelRuns, EmptyVolumeIsOneCube) {
  VoxelRuns runs({16, 16, 16});
  runs.finish();
  expectEmpty(runs, {7, 0, 3}, {0, 0, 0}, 3);
}

TEST(VoxelRuns, EmptySpaceComesInLargeAlignedCubes) {
  VoxelRuns runs({16, 16, 16});
  runs.add({{5, 6, 7}, 0}, 9);
  runs.finish();
  expectVoxel(runs, {5, 6, 7}, 9);
  expectEmpty(runs, {4, 6, 7}, {4, 6, 7}, 0);
  expectEmpty(runs, {6, 5, 7}, {6, 4, 6}, 1);
  expectEmpty(runs, {1, 1, 1}, {0, 0, 0}, 2);
  expectEmpty(runs, {15, 1, 9}, {8, 0, 8}, 3);
}

TEST(VoxelRuns, WordsAreThoseOfTheirCubes) {
  VoxelRuns runs({4, 4, 4});
  for (std::uint64_t code = 0; code < 8; ++code)
    runs.add({mortonCell(code), 0}, 5);
  runs.add({{2, 0, 0}, 1}, 5);
  runs.add({{0, 2, 0}, 1}, 6);
  runs.finish();
  EXPECT_EQ(runs.size(), 3u);
  expectVoxel(runs, {1, 1, 1}, 5);
  expectVoxel(runs, {3, 1, 0}, 5);
  expectVoxel(runs, {0, 3, 1}, 6);
  expectEmpty(runs, {2, 2, 0}, {2, 2, 0}, 1);
}

TEST(VoxelRuns, LargestExtentIsHeldSparsely) {
  const int last = (1 << kMaxLog2Extent) - 1;
  VoxelRuns runs({last + 1, last + 1, last + 1});
  runs.add({{0, 0, 0}, 0}, 1);
  runs.add({{last, last, last}, 0}, 2);
  runs.finish();
  expectVoxel(runs, {0, 0, 0}, 1);
  expectVoxel(runs, {last, last, last}, 2);
  expectEmpty(runs, {last, 0, 0}, {1 << 20, 0, 0}, 20);
}

TEST(VoxelRuns, FullVolumeOfTheLargestExtentIsOneRun) {
  const int side = 1 << kMaxLog2Extent;
  VoxelRuns runs({side, side, side});
  runs.add({{0, 0, 0}, kMaxLog2Extent}, 3);
  runs.finish();
  expectVoxel(runs, {side - 1, 7, side / 2}, 3);
}

} // namespace
} // namespace voxc::test
