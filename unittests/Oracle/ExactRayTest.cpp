// A ray's moments in exact arithmetic: their order, cells and times where doubles cannot tell.
#include "../../lib/Oracle/ExactRay.h"

#include <gtest/gtest.h>

#include <limits>

namespace voxc::test {
namespace {

constexpr float kSmallest = std::numeric_limits<float>::denorm_min();

TEST(ExactRay, OrdersMomentsByTimeThenByPhase) {
  const ExactRay ray({{0, 3, kSmallest}, {1, -1, 1}});
  const Moment x = ray.crossing(0, 1), y = ray.crossing(1, 2), z = ray.crossing(2, 1);
  EXPECT_TRUE(ray.compare(x, y) < 0); // Both at t = 1; y falls just after it.
  EXPECT_TRUE(ray.compare(y, x) > 0);
  EXPECT_TRUE(ray.compare(z, x) < 0); // 2^-149 sooner.
  EXPECT_TRUE(ray.compare(x, z) > 0);
  EXPECT_TRUE(ray.compare(x, x) == 0);
}

TEST(ExactRay, StartComesBeforeWhatHappensJustAfterIt) {
  const ExactRay ray({{0, 3, 0}, {1, -1, 0}});
  EXPECT_TRUE(ray.compare(Moment{}, ray.crossing(1, 3)) < 0);
  EXPECT_TRUE(ray.compare(Moment{}, ray.crossing(0, 0)) == 0);
}

TEST(ExactRay, CellsOfOtherAxesAreThoseAtTheMoment) {
  const ExactRay ray({{0, 0, 5}, {1, 2, -2}});
  const Moment risen = ray.crossing(0, 1); // t = 1: y = 2, z = 3.
  EXPECT_EQ(ray.cell(0, risen), 1);
  EXPECT_EQ(ray.cell(1, risen), 2);
  EXPECT_EQ(ray.cell(2, risen), 3);
  const Moment fallen = ray.crossing(2, 3);
  EXPECT_EQ(ray.cell(0, fallen), 1);
  EXPECT_EQ(ray.cell(1, fallen), 2);
  EXPECT_EQ(ray.cell(2, fallen), 2);
}

TEST(ExactRay, CellsBelowZeroAreRoundedDown) {
  const ExactRay ray({{-kSmallest, -3, -3}, {1, -1, 1}});
  const Moment moment = ray.crossing(0, 1); // y = -4 - 2^-149, z = -2 + 2^-149.
  EXPECT_EQ(ray.cell(1, moment), -5);
  EXPECT_EQ(ray.cell(2, moment), -2);
}

TEST(ExactRay, StartHasTheOriginsCells) {
  const ExactRay ray({{1, 2.5f, -0.5f}, {-1, 1, 0}});
  EXPECT_EQ(ray.cell(0, Moment{}), 1);
  EXPECT_EQ(ray.cell(1, Moment{}), 2);
  EXPECT_EQ(ray.cell(2, Moment{}), -1);
  EXPECT_EQ(ray.time(Moment{}), 0);
}

TEST(ExactRay, TinyTimesAreRoundedToo) {
  // 2^-150 is halfway between 0 and the smallest float32: to even; one and a half of those go to two.
  EXPECT_EQ(ExactRay({{1 - 0x1p-24f, 0, 0}, {0x1p126f, 0, 0}}).time({0, 1, false, 0x1p-150}), 0);
  EXPECT_EQ(ExactRay({{1 - 0x3p-24f, 0, 0}, {0x1p126f, 0, 0}}).time({0, 1, false, 0x3p-150}), 2 * kSmallest);
}

} // namespace
} // namespace voxc::test
