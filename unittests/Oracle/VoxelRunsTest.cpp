// Runs of voxels in Morton order: what is found where, and how much empty space around it.
#include "../../lib/Oracle/VoxelRuns.h"

#include <gtest/gtest.h>

namespace voxc::test {
namespace {

void expectCube(const VoxelRuns &runs, Int3 cell, Int3 low, int log2Side, std::uint32_t word) {
  const UniformCube found = runs.at(cell);
  EXPECT_EQ(found.cube.low, low);
  EXPECT_EQ(found.cube.log2Side, log2Side);
  EXPECT_EQ(found.word, word);
}

TEST(VoxelRuns, EmptyVolumeIsOneCube) {
  VoxelRuns runs({8, 8, 8});
  runs.finish();
  expectCube(runs, {7, 0, 3}, {0, 0, 0}, kMaxLog2Extent, 0);
}

TEST(VoxelRuns, EmptySpaceComesInTheLargestAlignedCubes) {
  VoxelRuns runs({16, 16, 16});
  runs.add({{5, 6, 7}, 0}, 9);
  runs.finish();
  expectCube(runs, {5, 6, 7}, {5, 6, 7}, 0, 9);
  expectCube(runs, {4, 6, 7}, {4, 6, 7}, 0, 0);
  expectCube(runs, {6, 5, 7}, {6, 4, 6}, 1, 0);
  expectCube(runs, {1, 1, 1}, {0, 0, 0}, 2, 0);
  expectCube(runs, {15, 1, 9}, {8, 0, 8}, 3, 0);
}

TEST(VoxelRuns, EqualNeighboursBecomeOneCube) {
  VoxelRuns runs({4, 4, 4});
  for (std::uint64_t code = 0; code < 8; ++code)
    runs.add({mortonCell(code), 0}, 5);
  runs.add({{2, 0, 0}, 1}, 5);
  runs.add({{0, 2, 0}, 1}, 6);
  runs.finish();
  expectCube(runs, {1, 1, 1}, {0, 0, 0}, 1, 5);
  expectCube(runs, {3, 1, 0}, {2, 0, 0}, 1, 5);
  expectCube(runs, {0, 3, 1}, {0, 2, 0}, 1, 6);
  expectCube(runs, {2, 2, 0}, {2, 2, 0}, 1, 0);
}

TEST(VoxelRuns, LargestExtentIsHeldSparsely) {
  const int last = (1 << kMaxLog2Extent) - 1;
  VoxelRuns runs({last + 1, last + 1, last + 1});
  runs.add({{0, 0, 0}, 0}, 1);
  runs.add({{last, last, last}, 0}, 2);
  runs.finish();
  expectCube(runs, {0, 0, 0}, {0, 0, 0}, 0, 1);
  expectCube(runs, {last, last, last}, {last, last, last}, 0, 2);
  expectCube(runs, {last, 0, 0}, {1 << 20, 0, 0}, 20, 0);
  expectCube(runs, {last - 1, last, last}, {last - 1, last, last}, 0, 0);
}

TEST(VoxelRuns, FullVolumeOfTheLargestExtentIsOneRun) {
  const int side = 1 << kMaxLog2Extent;
  VoxelRuns runs({side, side, side});
  runs.add({{0, 0, 0}, kMaxLog2Extent}, 3);
  runs.finish();
  expectCube(runs, {side - 1, 7, side / 2}, {0, 0, 0}, kMaxLog2Extent, 3);
}

} // namespace
} // namespace voxc::test
