// The classes of hard rays are what they say, repeatable, and aimed at the grid.
#include "voxc/Oracle/HardRays.h"

#include "../../lib/Oracle/ExactRay.h"
#include "../../lib/Oracle/ExactWalk.h"

#include <gtest/gtest.h>

#include <algorithm>
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
  EXPECT_TRUE(equal(verifyRays(kExtent, 500, 1), verifyRays(kExtent, 500, 1)));
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

TEST(HardRays, VerifyMixesItsShares) {
  unsigned percent = 0;
  for (const HardRayClass &row : hardRayClasses())
    percent += row.verifyShare;
  EXPECT_EQ(percent, 100u);
  const std::vector<Ray> rays = verifyRays(kExtent, 10000, 3);
  const auto axisParallel = std::ranges::count_if(
      rays, [](const Ray &ray) { return std::ranges::count(ray.direction, 0.0f) == 2; });
  EXPECT_GT(axisParallel, 1800); // 18 %, and the lines through lattice points that happen to be.
  EXPECT_LT(axisParallel, 2400);
}

} // namespace
} // namespace voxc::test
