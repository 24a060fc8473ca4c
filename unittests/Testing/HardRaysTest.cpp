// The classes of hard rays are what they say, repeatable, and aimed at the grid.
#include "testing/HardRays.h"

#include "Oracle/ExactRay.h"
#include "Oracle/ExactTraversal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace voxc::test {
namespace {

constexpr Int3 kExtent{32, 16, 8};

bool equal(const std::vector<Ray> &a, const std::vector<Ray> &b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Ray)) == 0;
}

TEST(HardRays, SameArgumentsGiveTheSameRays) {
  for (const HardRayClass &row : hardRayClasses()) {
    EXPECT_TRUE(equal(hardRays(kExtent, row.name, 50, 5), hardRays(kExtent, row.name, 50, 5))) << row.name;
    EXPECT_FALSE(equal(hardRays(kExtent, row.name, 50, 5), hardRays(kExtent, row.name, 50, 6))) << row.name;
  }
}

TEST(HardRays, UnknownClassHasNone) { EXPECT_TRUE(hardRays(kExtent, "easy", 10, 1).empty()); }

TEST(HardRays, OnlyOneClassIsNotFinite) {
  for (const HardRayClass &row : hardRayClasses()) {
    const bool finite = row.name != "not-finite";
    for (const Ray &ray : hardRays(kExtent, row.name, 500, 5))
      ASSERT_EQ(isFinite(ray), finite) << row.name;
  }
}

TEST(HardRays, EveryMovingClassMeetsTheGrid) {
  VoxelRuns full(kExtent);
  for (int low = 0; low < 32; low += 8) {
    full.add({{low, 0, 0}, 3}, 1);
    if (low % 16 == 8) {
      full.add({{low - 8, 8, 0}, 3}, 1);
      full.add({{low, 8, 0}, 3}, 1);
    }
  }
  full.finish();
  for (const HardRayClass &row : hardRayClasses()) {
    const std::vector<Ray> rays = hardRays(kExtent, row.name, 400, 9);
    const auto hits =
        std::ranges::count_if(rays, [&](const Ray &ray) { return traceExactly(full, ray).isHit(); });
    if (row.name == "not-finite")
      EXPECT_EQ(hits, 0);
    else
      EXPECT_GT(hits, 40) << row.name;
  }
}

TEST(HardRays, AxisClassesMoveAlongOneAxis) {
  for (const char *name : {"axis-centre", "axis-face", "axis-edge"})
    for (const Ray &ray : hardRays(kExtent, name, 200, 3))
      ASSERT_EQ(std::ranges::count(ray.direction, 0.0f), 2) << name;
}

TEST(HardRays, TouchingRaysMeetEdgesAndCorners) {
  // Rays aimed at a lone voxel or a cell anywhere: half-open cells still make some of them hits.
  const std::vector<Int3> voxel{{9, 5, 3}};
  VoxelRuns lone(kExtent);
  lone.add({voxel[0], 0}, 1);
  lone.finish();
  int touched = 0;
  for (const Ray &ray : hardRays({kExtent, voxel}, "touch", 1000, 3)) {
    const Explanation explained = explainExactly(lone, ray, 0);
    const Hit &hit = explained.hit;
    if (hit.isHit() && hit.t > 0) {
      const auto onLattice = [&](int axis) {
        const double at = ray.origin[axis] + double{hit.t} * ray.direction[axis];
        return at == std::floor(at);
      };
      touched += onLattice(0) + onLattice(1) + onLattice(2) >= 2;
    }
  }
  EXPECT_GT(touched, 50);
}

TEST(HardRays, VoxelsOfTheTargetAreAimedAt) {
  const Int3 huge{1 << 20, 1 << 20, 1 << 20};
  const std::vector<Int3> voxel{{700000, 5, 1 << 19}};
  VoxelRuns lone(huge);
  lone.add({voxel[0], 0}, 1);
  lone.finish();
  for (const char *name : {"outside", "axis-face", "diagonal", "whole", "touch", "solid", "on-boundary"}) {
    const std::vector<Ray> rays = hardRays({huge, voxel}, name, 400, 9);
    EXPECT_GT(std::ranges::count_if(rays, [&](const Ray &ray) { return traceExactly(lone, ray).isHit(); }),
              10)
        << name;
  }
}

TEST(HardRays, TiesAreExactAndBrokenByAnUlp) {
  const auto ties = [](const char *name) {
    const std::vector<Ray> rays = hardRays(kExtent, name, 400, 5);
    return std::ranges::count_if(rays, [](const Ray &ray) {
      // Boundaries are crossed together where a voxel of the full grid's inside is left by two faces.
      const ExactRay exact(ray);
      for (int x = 0; x <= kExtent.x; ++x)
        for (int y = 0; y <= kExtent.y; ++y)
          if (ray.direction[0] * (static_cast<float>(x) - ray.origin[0]) > 0 &&
              ray.direction[1] * (static_cast<float>(y) - ray.origin[1]) > 0) {
            const Moment a = exact.crossing(0, x), b = exact.crossing(1, y);
            if (exact.compare(a, {b.axis, b.face, a.after, b.approximate}) == 0)
              return true;
          }
      return false;
    });
  };
  EXPECT_GT(ties("exact-tie"), 250);
  EXPECT_LT(ties("broken-tie"), 250);
  EXPECT_LT(ties("near-tie"), 100);
}

} // namespace
} // namespace voxc::test
