// Each sentence of the definition of a hit (docs/ir.md), by hand.
#include "../../lib/Oracle/ExactTraversal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

namespace voxc::test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kLargest = std::numeric_limits<float>::max();
constexpr float kLeastFloat = std::numeric_limits<float>::denorm_min();
constexpr Int3 kNone{-1, -1, -1};

/// A grid of 8^3 voxels with some of them filled; word 1 + Morton code. Cells come in Morton order.
VoxelRuns gridOf(std::initializer_list<Int3> cells) {
  VoxelRuns runs({8, 8, 8});
  for (Int3 cell : cells)
    runs.add({cell, 0}, static_cast<std::uint32_t>(1 + mortonCode(cell)));
  runs.finish();
  return runs;
}

void expectHit(const VoxelRuns &voxels, const Ray &ray, Int3 voxel, float t) {
  const Hit hit = traceExactly(voxels, ray);
  EXPECT_EQ((Int3{hit.voxel[0], hit.voxel[1], hit.voxel[2]}), voxel);
  EXPECT_EQ(hit.t, t);
  EXPECT_EQ(hit.rgba, voxel == kNone ? 0 : 1 + mortonCode(voxel));
  EXPECT_EQ(hit.steps, 0u);
}

void expectMiss(const VoxelRuns &voxels, const Ray &ray) { expectHit(voxels, ray, kNone, 0); }

TEST(HitDefinition, CellsAreHalfOpen) {
  const VoxelRuns voxels = gridOf({{3, 3, 3}});
  expectHit(voxels, {{3, 3, 0.5f}, {0, 0, 1}}, {3, 3, 3}, 2.5f);
  expectMiss(voxels, {{4, 3, 0.5f}, {0, 0, 1}});
  expectMiss(voxels, {{3, 4, 0.5f}, {0, 0, 1}});
  expectHit(voxels, {{std::nextafter(4.0f, 0.0f), 3, 0.5f}, {0, 0, 1}}, {3, 3, 3}, 2.5f);
}

TEST(HitDefinition, DirectionNeedNotBeUnit) {
  const VoxelRuns voxels = gridOf({{4, 0, 0}});
  expectHit(voxels, {{-4, 0.5f, 0.5f}, {0.125f, 0, 0}}, {4, 0, 0}, 64);
  expectHit(voxels, {{-4, 0.5f, 0.5f}, {16, 0, 0}}, {4, 0, 0}, 0.5f);
}

TEST(HitDefinition, OriginsCellIsHitAtZero) {
  const VoxelRuns voxels = gridOf({{2, 2, 2}});
  expectHit(voxels, {{2.5f, 2.25f, 2}, {-1, 3, 0}}, {2, 2, 2}, 0);
}

TEST(HitDefinition, NothingBehindTheOriginCounts) {
  const VoxelRuns voxels = gridOf({{2, 2, 2}});
  expectMiss(voxels, {{3.5f, 2.5f, 2.5f}, {1, 0, 0}});
  expectMiss(voxels, {{-1, 2.5f, 2.5f}, {-1, 0, 0}});
}

TEST(HitDefinition, OriginOnABoundaryIsInTheUpperCell) {
  expectHit(gridOf({{2, 0, 0}, {3, 0, 0}}), {{3, 0.5f, 0.5f}, {-1, 0, 0}}, {3, 0, 0}, 0);
}

TEST(HitDefinition, FallingAxisLeavesItsBoundaryJustAfterZero) {
  expectHit(gridOf({{2, 0, 0}}), {{3, 0.5f, 0.5f}, {-1, 0, 0}}, {2, 0, 0}, 0);
}

TEST(HitDefinition, RisingAxesChangeTogetherBeforeFallingOnes) {
  // From (2,2,4) at t = 1: x and y rise into (3,3,4); just after, z falls into (3,3,3).
  const Ray ray{{2.5f, 2.5f, 4.5f}, {0.5f, 0.5f, -0.5f}};
  expectHit(gridOf({{3, 3, 4}}), ray, {3, 3, 4}, 1);
  expectHit(gridOf({{3, 3, 3}}), ray, {3, 3, 3}, 1);
  expectHit(gridOf({{3, 3, 3}, {3, 3, 4}}), ray, {3, 3, 4}, 1);
  for (Int3 skipped : {Int3{3, 2, 4}, {2, 3, 4}, {2, 2, 3}, {3, 2, 3}, {2, 3, 3}})
    expectMiss(gridOf({skipped}), ray);
}

TEST(HitDefinition, FallingAxesChangeTogether) {
  const Ray ray{{4.5f, 4.5f, 0.5f}, {-1, -1, 0}};
  expectMiss(gridOf({{4, 3, 0}}), ray);
  expectMiss(gridOf({{3, 4, 0}}), ray);
  expectHit(gridOf({{3, 3, 0}}), ray, {3, 3, 0}, 0.5f);
}

TEST(HitDefinition, InstantInsideTheGridCounts) {
  // At t = 1 x rises into the grid; just after, y falls out of it.
  expectHit(gridOf({{0, 0, 0}}), {{-1, 1, 0}, {1, -1, 0}}, {0, 0, 0}, 1);
  // At t = 1 x rises into the grid just as y rises out of it.
  expectMiss(gridOf({{0, 7, 0}}), {{-1, 7, 0}, {1, 1, 0}});
  // Just after t = 1 x falls into the grid; y has left it at t = 1, or leaves it at the same moment.
  expectMiss(gridOf({{7, 7, 0}}), {{9, 7, 0}, {-1, 1, 0}});
  expectMiss(gridOf({{7, 0, 0}}), {{9, 1, 0}, {-1, -1, 0}});
}

TEST(HitDefinition, EntryJustAfterATimeSeesOtherAxesThen) {
  // Just after t = 1 x falls into 7, and y, at 3 then, falls into 2.
  expectHit(gridOf({{7, 2, 0}}), {{9, 4, 0}, {-1, -1, 0}}, {7, 2, 0}, 1);
  expectMiss(gridOf({{7, 3, 0}}), {{9, 4, 0}, {-1, -1, 0}});
  // With y rising it is in 5 at t = 1 already.
  expectHit(gridOf({{7, 5, 0}}), {{9, 4, 0}, {-1, 1, 0}}, {7, 5, 0}, 1);
}

TEST(HitDefinition, ZeroComponentNeverChangesItsCell) {
  const VoxelRuns voxels = gridOf({{5, 2, 3}});
  for (float zero : {0.0f, -0.0f}) {
    expectHit(voxels, {{-1e30f, 2, 3}, {1e30f, zero, zero}}, {5, 2, 3}, 1);
    expectMiss(voxels, {{0, 3, 3}, {1, zero, zero}});
    expectMiss(voxels, {{0, 8, 3}, {1, zero, zero}});
  }
}

TEST(HitDefinition, DirectionZeroSeesTheOriginsCellAlone) {
  const VoxelRuns voxels = gridOf({{5, 2, 3}});
  expectHit(voxels, {{5, 2.5f, 3.75f}, {0, -0.0f, 0}}, {5, 2, 3}, 0);
  expectMiss(voxels, {{4.75f, 2.5f, 3.75f}, {0, 0, 0}});
  expectMiss(voxels, {{-5, 2.5f, 3.75f}, {0, 0, 0}});
}

TEST(HitDefinition, NonFiniteComponentIsAMiss) {
  const VoxelRuns voxels = gridOf({{0, 0, 0}});
  for (float bad : {kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN()})
    for (int component = 0; component < 6; ++component) {
      Ray ray{{0.5f, 0.5f, 0.5f}, {1, 0, 0}};
      (component < 3 ? ray.origin[component] : ray.direction[component - 3]) = bad;
      expectMiss(voxels, ray);
    }
}

TEST(HitDefinition, TimeBeyondFloatIsInfinityAndTheHitStands) {
  expectHit(gridOf({{5, 0, 0}}), {{-1e6f, 0, 0}, {kLeastFloat, 0, 0}}, {5, 0, 0}, kInfinity);
  // The largest finite t; then 2^128 - 2^103, halfway to 2^128, a tie that goes to the even side.
  expectHit(gridOf({{0, 0, 0}}), {{-0x1.fffffep23f, 0, 0}, {0x1p-104f, 0, 0}}, {0, 0, 0}, kLargest);
  expectHit(gridOf({{1, 0, 0}}), {{-0x1.fffffep24f, 0, 0}, {0x1p-103f, 0, 0}}, {1, 0, 0}, kInfinity);
}

TEST(HitDefinition, TimeIsRoundedToNearestEven) {
  // t = 16777216 + 1 lies halfway between two float32, 16777216 + 3 between the next two.
  expectHit(gridOf({{1, 0, 0}}), {{-16777216, 0, 0}, {1, 0, 0}}, {1, 0, 0}, 16777216);
  expectHit(gridOf({{3, 0, 0}}), {{-16777216, 0, 0}, {1, 0, 0}}, {3, 0, 0}, 16777220);
  expectHit(gridOf({{1, 0, 0}}), {{0, 0, 0}, {3, 0, 0}}, {1, 0, 0}, 1.0f / 3.0f);
}

TEST(HitDefinition, TimeIsRoundedOnce) {
  // In doubles both quotients are the tie itself; exactly they are 3e-9 above and 2e-9 below it.
  expectHit(gridOf({{4, 0, 0}}), {{-0x1.d68d04p-29f, 0, 0}, {0x1.2c0554p-23f, 0, 0}}, {4, 0, 0}, 28631130);
  expectHit(gridOf({{6, 0, 0}}), {{0x1.ad3a02p-28f, 0, 0}, {0x1.adb81p-23f, 0, 0}}, {6, 0, 0}, 29984482);
}

TEST(HitDefinition, TinyDifferencesDecide) {
  // At the start of x's cell 1 the ray's y is 1 exactly, or the smallest float below it, or above.
  const VoxelRuns upper = gridOf({{1, 1, 0}}), lower = gridOf({{1, 0, 0}});
  const Ray through{{0, 0, 0}, {1, 1, 0}};
  expectHit(upper, through, {1, 1, 0}, 1);
  expectMiss(lower, through);
  const Ray below{{0, -kLeastFloat, 0}, {1, 1, 0}};
  expectMiss(gridOf({{0, 0, 0}}), {{0, -kLeastFloat, 0}, {1, -1, 0}});
  expectHit(lower, below, {1, 0, 0}, 1);
  expectHit(upper, below, {1, 1, 0}, 1);
}

TEST(HitDefinition, LargestComponentsAreOrdinary) {
  const VoxelRuns voxels = gridOf({{0, 0, 0}});
  expectHit(voxels, {{-kLargest, -kLargest, -kLargest}, {kLargest, kLargest, kLargest}}, {0, 0, 0}, 1);
  expectHit(voxels, {{0.5f, 0.5f, 0.5f}, {kLargest, -kLargest, kLargest}}, {0, 0, 0}, 0);
  expectMiss(voxels, {{-kLargest, 0, 0}, {kLargest, kLargest, 0}});
}

} // namespace
} // namespace voxc::test
