// The face of entry and the cells on the way, against brute force in rational arithmetic.
#include "testing/HardRays.h"

#include "../../lib/Oracle/ExactTraversal.h"
#include "BruteForce.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace voxc::test {
namespace {

VoxelRuns gridOf(Int3 extent, std::initializer_list<Int3> cells) {
  VoxelRuns runs(extent);
  for (Int3 cell : cells)
    runs.add({cell, 0}, 7);
  runs.finish();
  return runs;
}

/// The first cells of a brute-force list up to the one that is not empty.
std::vector<Int3> upToTheFirstVoxel(const VoxelRuns &voxels, std::vector<Int3> cells) {
  const auto voxel = std::ranges::find_if(cells, [&](Int3 cell) { return voxels.word(cell) != 0; });
  if (voxel != cells.end())
    cells.erase(voxel + 1, cells.end());
  return cells;
}

void expectExplained(const VoxelRuns &voxels, const Ray &ray, std::string_view name) {
  const Explanation explained = explainExactly(voxels, ray, 1000);
  const Hit hit = traceExactly(voxels, ray);
  ASSERT_EQ(std::memcmp(&explained.hit, &hit, sizeof hit), 0) << name;
  ASSERT_TRUE(explained.complete);
  ASSERT_EQ(explained.cells, upToTheFirstVoxel(voxels, bruteForceCells(voxels.extent(), ray))) << name;
  if (!hit.isHit()) {
    ASSERT_EQ(explained.face, Face{}) << name;
    return;
  }
  const Int3 cell{hit.voxel[0], hit.voxel[1], hit.voxel[2]};
  ASSERT_EQ(explained.cells.back(), cell) << name;
  ASSERT_EQ(explained.face, bruteForceFace(ray, cell)) << name;
}

TEST(Explain, AgreesWithBruteForceOnHardRays) {
  const Int3 extent{5, 4, 6};
  const VoxelRuns voxels = gridOf(extent, {{0, 0, 0}, {3, 0, 1}, {1, 2, 1}, {4, 3, 5}});
  for (const test::HardRayClass &row : test::hardRayClasses())
    for (const Ray &ray : test::hardRays(extent, row.name, 150, 3))
      if (row.name != "not-finite")
        expectExplained(voxels, ray, row.name);
}

TEST(Explain, OfSeveralFacesTheFirstAxisCounts) {
  const VoxelRuns voxels = gridOf({8, 8, 8}, {{2, 2, 2}});
  const auto face = [&](const Ray &ray) { return explainExactly(voxels, ray, 0).face; };
  EXPECT_EQ(face({{0, 0, 0}, {1, 1, 1}}), (Face{0, -1}));
  EXPECT_EQ(face({{0.5f, 0, 0}, {1, 1, 1}}), (Face{1, -1}));
  EXPECT_EQ(face({{2.5f, 5, 5}, {0, -1, -1}}), (Face{1, 1}));
  // Rising axes change first: the falling one brings the ray in, just after.
  EXPECT_EQ(face({{0, 5, 2.5f}, {1, -1, 0}}), (Face{1, 1}));
  // From within there is none; from the high face, which belongs to the next cell, there is.
  EXPECT_EQ(face({{2, 2, 2}, {1, 1, 1}}), Face{});
  EXPECT_EQ(face({{3, 2.5f, 2.5f}, {-1, 0, 0}}), (Face{0, 1}));
}

TEST(Explain, ListsNoMoreCellsThanAreAskedFor) {
  const VoxelRuns voxels = gridOf({8, 8, 8}, {{6, 0, 0}});
  const Ray ray{{-4, 0.5f, 0.5f}, {1, 0, 0}};
  const Explanation all = explainExactly(voxels, ray, 7);
  EXPECT_TRUE(all.complete);
  EXPECT_EQ(all.cells.size(), 7u);
  const Explanation some = explainExactly(voxels, ray, 6);
  EXPECT_FALSE(some.complete);
  EXPECT_EQ(some.cells.size(), 6u);
  EXPECT_EQ(some.hit.voxel[0], 6);
}

TEST(Explain, ARayThatIsNotFiniteHasNoCells) {
  const VoxelRuns voxels = gridOf({8, 8, 8}, {{0, 0, 0}});
  for (const Ray &ray : test::hardRays(Int3{8, 8, 8}, "not-finite", 50, 3)) {
    const Explanation explained = explainExactly(voxels, ray, 100);
    EXPECT_FALSE(explained.hit.isHit());
    EXPECT_TRUE(explained.cells.empty());
  }
}

} // namespace
} // namespace voxc::test
