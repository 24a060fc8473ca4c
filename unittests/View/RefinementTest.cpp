// The steps in which a picture gets fine, and the table of keys.
#include "view/Refinement.h"
#include "view/Keys.h"

#include <gtest/gtest.h>

#include <set>

namespace voxc::view {
namespace {

/// Renders on a machine that takes so many seconds for a sample of the whole picture, and so many beside.
void run(Refinement &refinement, double secondsOfAll, double beside = 0) {
  const RefinementStep step = *refinement.next();
  refinement.took(step, beside + secondsOfAll * step.samples / (step.divisor * step.divisor));
  refinement.done(step);
}

TEST(Refinement, GoesFromADraftToTheFinest) {
  Refinement refinement(0.04, 16);
  int divisor = 100;
  unsigned samples = 1;
  EXPECT_TRUE(refinement.isFirst());
  for (int steps = 0; refinement.next(); ++steps) {
    const RefinementStep step = *refinement.next();
    EXPECT_EQ(step.isDraft, steps == 0);
    EXPECT_TRUE(step.divisor < divisor || step.samples > samples) << steps;
    EXPECT_TRUE(step.samples == 1 || step.divisor == 1);
    divisor = step.divisor;
    samples = step.samples;
    run(refinement, 1);
    EXPECT_FALSE(refinement.isFirst());
    ASSERT_LT(steps, 20);
  }
  EXPECT_EQ(divisor, 1);
  EXPECT_EQ(samples, 16u);
}

TEST(Refinement, DraftsFitTheBudget) {
  for (const double secondsOfAll : {0.001, 0.1, 0.7, 3.0, 20.0}) {
    Refinement refinement(0.04, 16);
    for (int picture = 0; picture < 10; ++picture) {
      refinement.restart();
      run(refinement, secondsOfAll, 0.005);
    }
    refinement.restart();
    const int divisor = refinement.next()->divisor;
    EXPECT_LE(secondsOfAll / (divisor * divisor), 0.04) << secondsOfAll;
    // Not much coarser than it has to be.
    if (divisor > 1) {
      EXPECT_GT(secondsOfAll / ((divisor - 1) * (divisor - 1)), 0.04 - 0.01) << secondsOfAll;
    }
  }
}

TEST(Refinement, ABusierMachineGetsCoarserDrafts) {
  Refinement refinement(0.04, 16);
  run(refinement, 1);
  refinement.restart();
  const int quiet = refinement.next()->divisor;
  run(refinement, 9);
  refinement.restart();
  EXPECT_EQ(refinement.next()->divisor, 3 * quiet);
}

TEST(Refinement, FinerStepsSayNothingOfDrafts) {
  Refinement refinement(0.04, 16);
  run(refinement, 1);
  run(refinement, 1000);
  refinement.restart();
  EXPECT_EQ(refinement.next()->divisor, 5);
  refinement.forgetTimes();
  EXPECT_EQ(refinement.next()->divisor, 8);
}

TEST(Refinement, EndsWithTheSamplesAskedFor) {
  for (const unsigned most : {1u, 3u, 4u, 100u}) {
    Refinement refinement(0.04, most);
    RefinementStep last;
    while (refinement.next()) {
      last = *refinement.next();
      run(refinement, 1);
    }
    EXPECT_EQ(last.samples, most);
  }
}

TEST(Keys, HaveEachTheirOwnActionInTheOrderOfTheTable) {
  std::set<std::string_view> keys;
  int number = 0;
  for (const KeyKind &kind : keyKinds()) {
    EXPECT_EQ(int(kind.action), number++);
    EXPECT_TRUE(keys.insert(kind.key).second) << kind.key;
    EXPECT_EQ(actionOf(kind.key), kind.action);
    EXPECT_NE(keysHelp().find(std::string(kind.summary)), std::string::npos);
  }
  EXPECT_EQ(int(Action::Escape) + 1, number);
  EXPECT_FALSE(actionOf("L"));
}

} // namespace
} // namespace voxc::view
