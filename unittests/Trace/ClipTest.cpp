// What planes keep of rays.
#include "voxc/Trace/Clip.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace voxc {
namespace {

/// The float32 before a moment.
float before(float moment) { return std::nextafter(moment, -INFINITY); }

Clip keep(std::vector<ClipPlane> planes) { return {std::move(planes)}; }

TEST(Clip, KeepsTheSideOfTheNormal) {
  const Clip clip = keep({{{1, 0, 0}, 10}});
  const RayBounds towards = clip.boundsOf(makeRay({0, 5, 5}, {2, 0, 0}));
  EXPECT_EQ(towards.tmin, before(5));
  EXPECT_EQ(towards.tmax, std::numeric_limits<float>::infinity());
  // What is entered as the ray leaves is cut away: its bound lies before.
  const RayBounds away = clip.boundsOf(makeRay({20, 5, 5}, {-2, 0, 0}));
  EXPECT_GT(away.tmin, 0);
  EXPECT_LT(away.tmin, 1e-30f);
  EXPECT_EQ(away.tmax, before(5));
}

TEST(Clip, RaysBesideAPlaneSeeAllOrNothing) {
  const Clip clip = keep({{{0, 1, 0}, 3}});
  EXPECT_EQ(clip.boundsOf(makeRay({0, 4, 0}, {1, 0, 0})).tmax, std::numeric_limits<float>::infinity());
  EXPECT_LT(clip.boundsOf(makeRay({0, 2, 0}, {1, 0, 0})).tmax, 0);
  // Away from what is kept.
  const RayBounds away = clip.boundsOf(makeRay({0, 2, 0}, {0, -1, 0}));
  EXPECT_LT(away.tmax, away.tmin);
}

TEST(Clip, ABoxIsSixPlanes) {
  Clip clip;
  EXPECT_TRUE(clip.cutsNothing());
  clip.keepBox({2, 3, 4}, {8, 9, 10});
  EXPECT_EQ(clip.planes.size(), 6u);
  const RayBounds through = clip.boundsOf(makeRay({5, 6, -10}, {0, 0, 1}));
  EXPECT_EQ(through.tmin, before(14));
  EXPECT_EQ(through.tmax, before(20));
  const RayBounds past = clip.boundsOf(makeRay({5, 20, -10}, {0, 0, 1}));
  EXPECT_LT(past.tmax, past.tmin);
}

TEST(Clip, PlanesOfAModelAreThoseOfItsVoxels) {
  // Voxels of 2 x 2 x 6, turned and moved: x of the model is z of the voxels.
  const Transform toModel({0, 2, 0}, {0, 0, 2}, {6, 0, 0}, {100, 0, 0});
  const ClipPlane plane = inVoxels({{1, 0, 0}, 130}, toModel);
  // Points of voxels z = 5 lie in it.
  EXPECT_NEAR(glm::dot(plane.normal, glm::dvec3(7, 8, 5)), plane.offset, 1e-9);
  EXPECT_GT(glm::dot(plane.normal, glm::dvec3(7, 8, 6)), plane.offset);
}

TEST(Clip, BoundsAllRaysAlikeOnAnyThreads) {
  Clip clip;
  clip.keepBox({-1, -1, -1}, {1, 1, 1});
  std::vector<Ray> rays;
  for (int i = 0; i < 20000; ++i)
    rays.push_back(makeRay({float(i % 7) - 3, float(i % 5) - 2, -9}, {0.01f * float(i % 11), 0, 1}));
  const std::vector<BoundedRay> one = clip.bounded(rays, 1), three = clip.bounded(rays, 3);
  ASSERT_EQ(one.size(), rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_EQ(one[i].bounds(), clip.boundsOf(rays[i]));
    EXPECT_EQ(three[i].bounds(), one[i].bounds());
    EXPECT_EQ(one[i].origin[0], rays[i].origin[0]);
  }
}

TEST(Clip, NumbersThatAreNoneCutNothingOff) {
  const Clip clip = keep({{{1, 0, 0}, 10}});
  const RayBounds bounds = clip.boundsOf(makeRay({0, 0, 0}, {NAN, 0, 0}));
  EXPECT_FALSE(std::isnan(bounds.tmin) || std::isnan(bounds.tmax));
  const RayBounds far = clip.boundsOf(makeRay({0, 0, 0}, {1e-38f, 0, 0}));
  EXPECT_FALSE(std::isnan(far.tmin));
  EXPECT_GT(far.tmin, 1e38f);
}

} // namespace
} // namespace voxc
