// Rays that are made to fit a kernel: what they become, and that the memory for them stays.
#include "Trace/Rays/FittingRays.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace voxc {
namespace {

TEST(FittingRays, GetBoundsThatBindNothing) {
  const std::vector<Ray> rays = {{{1, 2, 3}, {4, 5, 6}}, {{7, 8, 9}, {1, 0, 0}}};
  FittingRays fitting;
  const auto fit = fitting.fit(rays, true);
  ASSERT_TRUE(fit) << fit.error().message;
  ASSERT_EQ(fit->size(), 2u);
  EXPECT_TRUE(fit->isBounded());
  EXPECT_EQ(fit->origin(1)[0], 7);
  EXPECT_EQ((*fit)[1].direction[0], 1);
}

TEST(FittingRays, AreThoseGivenWhereTheyFit) {
  const std::vector<Ray> rays(3);
  FittingRays fitting;
  EXPECT_EQ(fitting.fit(rays, false)->origin(0), rays[0].origin);
  const std::vector<BoundedRay> bounded(3);
  EXPECT_EQ(fitting.fit(bounded, true)->origin(0), bounded[0].origin);
  EXPECT_FALSE(fitting.fit(bounded, false));
}

/// A second call on as many rays, or fewer, is given the same memory.
TEST(FittingRays, StayWhereTheyAre) {
  const std::vector<Ray> rays(1000);
  FittingRays fitting;
  const float *first = fitting.fit(rays, true)->origin(0);
  for (const std::size_t count : {std::size_t{1000}, std::size_t{10}, std::size_t{0}, std::size_t{1000}}) {
    const auto fit = fitting.fit(RaySpan(rays).subspan(0, count), true);
    EXPECT_EQ(fit->size(), count);
    EXPECT_TRUE(fit->isBounded());
    EXPECT_TRUE(count == 0 || fit->origin(0) == first);
  }
}

} // namespace
} // namespace voxc
