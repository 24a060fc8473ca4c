// What a budget of time allows, by a clock that the test moves.
#include "voxc/Measure/TimeBudget.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>

namespace voxc::measure {
namespace {

struct Clock {
  std::shared_ptr<double> seconds = std::make_shared<double>(100);
  double operator()() const { return *seconds; }
};

TEST(TimeBudget, AllowsWhatEndsBeforeIt) {
  const Clock clock;
  const TimeBudget budget(10, clock);
  EXPECT_EQ(budget.left(), 10);
  EXPECT_TRUE(budget.allows(9));
  *clock.seconds += 4;
  EXPECT_EQ(budget.spent(), 4);
  EXPECT_TRUE(budget.allows(5));
  EXPECT_FALSE(budget.allows(6));
  EXPECT_FALSE(budget.isOver());
  *clock.seconds += 6;
  EXPECT_TRUE(budget.isOver());
}

TEST(TimeBudget, MayEndAtAnotherTimeFromTheSameBeginning) {
  const Clock clock;
  const TimeBudget budget(10, clock);
  *clock.seconds += 8;
  EXPECT_EQ(budget.endingAfter(9).left(), 1);
  EXPECT_EQ(budget.endingAfter(11).left(), 3);
  EXPECT_EQ(budget.left(), 2);
}

/// Work that asks its progress ends with the budget, and with the flag as before.
TEST(TimeBudget, StopsWorkWhenItIsOver) {
  const Clock clock;
  std::atomic<bool> flag = false;
  bool isAsked = false;
  const Progress progress =
      TimeBudget(2, clock).within({.stop = &flag, .ask = [&isAsked] { return isAsked; }});
  EXPECT_FALSE(progress.stopped());
  isAsked = true;
  EXPECT_TRUE(progress.stopped());
  isAsked = false;
  flag = true;
  EXPECT_TRUE(progress.stopped());
  flag = false;
  EXPECT_FALSE(progress.silent().stopped());
  *clock.seconds += 2;
  EXPECT_TRUE(progress.silent().stopped());
}

TEST(TimeBudget, HasNoEndUnlessOneIsGiven) {
  const TimeBudget budget;
  EXPECT_TRUE(budget.allows(1e30));
  EXPECT_FALSE(budget.within({}).stopped());
}

} // namespace
} // namespace voxc::measure
