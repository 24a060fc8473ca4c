// What `voxc verify` traces is repeatable, and mixed as it says.
#include "voxc/Oracle/VerifyRays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace voxc {
namespace {

constexpr Int3 kExtent{32, 16, 8};

bool equal(const std::vector<Ray> &a, const std::vector<Ray> &b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Ray)) == 0;
}

TEST(VerifyRays, SameArgumentsGiveTheSameRays) {
  EXPECT_TRUE(equal(verifyRays(kExtent, 500, 1), verifyRays(kExtent, 500, 1)));
  EXPECT_FALSE(equal(verifyRays(kExtent, 500, 1), verifyRays(kExtent, 500, 2)));
}

TEST(VerifyRays, MixesItsShares) {
  const std::vector<Ray> rays = verifyRays(kExtent, 10000, 3);
  const auto axisParallel = std::ranges::count_if(
      rays, [](const Ray &ray) { return std::ranges::count(ray.direction, 0.0f) == 2; });
  EXPECT_GT(axisParallel, 1800); // 18 %, and the lines through lattice points that happen to be.
  EXPECT_LT(axisParallel, 2400);
}

TEST(VerifyRays, AimsAtVoxels) {
  const Int3 voxel{31, 0, 7};
  const std::vector<Ray> rays = verifyRays({kExtent, std::span(&voxel, 1)}, 10000, 3);
  const auto startsAtCorner = std::ranges::count_if(rays, [&](const Ray &ray) {
    const float *o = ray.origin;
    return (o[0] == 31 || o[0] == 32) && (o[1] == 0 || o[1] == 1) && (o[2] == 7 || o[2] == 8);
  });
  EXPECT_GT(startsAtCorner, 300); // Of 20 % that start inside half do so at lattice points.
}

} // namespace
} // namespace voxc
