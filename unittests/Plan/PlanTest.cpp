// Plans as text, and the rules that they keep.
#include "TestLength.h"
#include "testing/RandomFormat.h"

#include "voxc/Layout/SlotKind.h"
#include "voxc/Plan/Plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <utility>

namespace voxc {
namespace {

using ::testing::HasSubstr;

/// What is said first of a plan; "" if it is right.
std::string problemOf(const Plan &plan) {
  Diagnostics diagnostics;
  verify(plan, diagnostics);
  return diagnostics.hasErrors() ? diagnostics.all().front().message : "";
}

TEST(PlanText, IsReadAsItWasPrinted) {
  std::mt19937 random(5);
  for (int i = 0; i < test::rounds(300); ++i) {
    Format format = test::randomFormat(random, test::pick(random, 2, 8));
    format.setAttribute(kDetailAttribute, random() % 2 ? "cone" : "full");
    format.setAttribute(kPrecisionAttribute, random() % 2 ? "fast" : "exact");
    if (const auto query = static_cast<Query>(random() % 4); query != Query::Closest) {
      format.setAttribute(kQueryAttribute, toString(query));
    } else {
      format.setAttribute(kFaceAttribute, random() % 2 ? "yes" : "no");
      format.setAttribute(kColourAttribute, random() % 2 ? "yes" : "no");
      format.setAttribute(kTAttribute, random() % 2 ? "yes" : "no");
    }
    if (problemOfQuestion(format).empty() && random() % 2) {
      format.setAttribute(kBoundsAttribute, "yes");
      if (!problemOfQuestion(format).empty())
        format.setAttribute(kBoundsAttribute, "no");
    }
    const Plan plan =
        *makePlan(format, {.addressing = random() % 2 ? Addressing::Segments : Addressing::Buffer,
                           .loops = random() % 2 ? Loops::Whole : Loops::Cut,
                           .arithmetic = static_cast<Arithmetic>(random() % 3)});
    EXPECT_EQ(problemOf(plan), "") << printPlan(plan);
    Diagnostics diagnostics;
    const Plan parsed = parsePlan(printPlan(plan), diagnostics);
    EXPECT_FALSE(diagnostics.hasErrors()) << printPlan(plan);
    EXPECT_EQ(parsed, plan) << printPlan(plan);
    EXPECT_EQ(printPlan(parsed), printPlan(plan));
    EXPECT_TRUE(parseFinishedPlan(printPlan(plan), "plan")) << "it makes all choices: " << printPlan(plan);
  }
}

TEST(PlanText, IsNeverBelieved) {
  std::mt19937 random(6);
  for (int i = 0; i < test::rounds(2000); ++i) {
    std::string text = printPlan(*makePlan(test::randomFormat(random, 5)));
    for (int changes = test::pick(random, 1, 3); changes > 0; --changes) {
      const std::size_t at = random() % text.size();
      if (random() % 2)
        text.erase(at, 1 + random() % 4);
      else
        text.insert(at, 1, "0123456789()=,x {}"[random() % 18]);
    }
    Diagnostics diagnostics;
    const Plan plan = parsePlan(text, diagnostics);
    if (!diagnostics.hasErrors()) {
      EXPECT_EQ(problemOf(plan), "") << text;
    }
  }
}

struct BrokenRule {
  const char *format;
  std::function<void(Plan &)> breakIt;
  const char *problem;
};

TEST(PlanRules, AreEachHeld) {
  const BrokenRule rules[] = {
      {"R(2^3) G(3)", [](Plan &p) { p.layout.strata[0].log2Cell = 2; }, "what is below has 2^3"},
      {"R(2^3) R(2^3)", [](Plan &p) { p.layout.strata[1].log2Shape.x = 1; }, "must be a cube"},
      {"G(3)", [](Plan &p) { p.layout.strata[0].depth = 40; }, "at most 2^21"},
      {"G(3)", [](Plan &p) { p.layout.strata[0].encoding = Distances{}; }, "packed slots, and what others"},
      {"R(2^3)", [](Plan &p) { p.layout.strata[0].depth = 2; }, "one layer"},
      {"R(2^3)", [](Plan &p) { p.layout.strata[0].encoding = Distances{}; }, "a reach of 1 at least"},
      {"D(2^3, 4)",
       [](Plan &p) { std::get<Distances>(p.layout.strata[0].encoding).place = DistancePlace::InSlot; },
       "alpha of 0"},
      {"M(2^3)", [](Plan &p) { p.layout.strata[0].slots = nullptr; }, "has no slots"},
      {"M(2^3) R(1^3)", [](Plan &p) { p.layout.strata[0].encoding = Distances{.reach = 3}; },
       "what others have"},
      {"M(3^3) R(1^3)", [](Plan &p) { p.layout.strata[0].slots = findSlotKind("brick"); }, "4 x 4 x 4"},
      {"M(2^3) R(1^3)",
       [](Plan &p) {
         p.layout.strata[0].slots = findSlotKind("numbered");
         p.layout.strata[0].encoding = Numbers{.bits = 9};
       },
       "level 2 has short pointers, which lead to the last level alone"},
      {"G(2) R(1^3)", [](Plan &p) { p.layout.strata[0].slots = findSlotKind("dense"); },
       "dense slots, and what"},
      {"S(2)", [](Plan &p) { p.layout.strata[0].encoding = Leaves{}; },
       "level 1 has siblings slots, and what others have"},
      {"G(2)", [](Plan &p) { p.traversals[0].descent = Descent::Index; }, "traversed by index"},
      {"H(2^3)", [](Plan &p) { p.traversals[0].descent = Descent::Single; }, "traversed by index"},
      {"G(2)", [](Plan &p) { p.traversals[0].descent = Descent::Single; }, "more than a single cell"},
      {"G(2)", [](Plan &p) { p.traversals[0].stops = true; }, "detail=cone alone"},
      {"G(2)", [](Plan &p) { p.bounded = true, p.detail = Detail::Cone; }, "stops at voxels alone"},
      {"G(2)", [](Plan &p) { p.traversals.clear(); }, "how it is traversed"},
      {"G(2)", [](Plan &p) { p.steps = StepArithmetic::Float64; }, "arithmetic=ieee"},
      {"G(2)", [](Plan &p) { p.stack = Stack::Shared, p.packing = Packing::Packets; },
       "no memory of a group"},
      {"G(2)", [](Plan &p) { p.query = Query::Any; }, "query=closest alone has"},
      {"G(2)", [](Plan &p) { p.outputs = {.voxel = false, .t = false, .colour = false}; }, "no output"},
      {"G(2)", [](Plan &p) { p.query = Query::Occupancy, p.outputs = outputsOf(p.query); },
       "without a traversal"},
      {"G(2)", [](Plan &p) { p.constructions.clear(); }, "traversed and constructed"},
      {"G(2)", [](Plan &p) { p.speculative = true; }, "levels=direct and precision=exact"},
      {"G(2)", [](Plan &p) { p.spanFaces = SpanFaces::Lookup; }, "with levels=direct alone"},
      {"G(2)", [](Plan &p) { p.packetWidth = PacketWidth::Narrow; }, "packing=packets alone"},
      {"G(2)", [](Plan &p) { p.traversals[0].lookUp = Loops::Cut; }, "where they loop"},
      {"G(2)", [](Plan &p) { p.traversals[0].readsValues = false; }, "nobody asks"},
      {"G(2)", [](Plan &p) { p.traversals[0].voxelSteps = true; }, "in grids of such"},
      {"R(2^3)", [](Plan &p) { p.constructions[0].bricks = true; }, "trees of voxels"},
      {"S(2)", [](Plan &p) { p.constructions[0].looksAhead = true; }, "no siblings"},
  };
  for (const BrokenRule &rule : rules) {
    Plan plan = *makePlan(*parseFormat(rule.format));
    EXPECT_EQ(problemOf(plan), "");
    rule.breakIt(plan);
    EXPECT_THAT(problemOf(plan), HasSubstr(rule.problem)) << rule.format;
  }
}

TEST(PlanRules, SayWhatAFinishedPlanHas) {
  const BrokenRule rules[] = {
      {"G(2)", [](Plan &p) { p.levelTraversal = LevelTraversal::Auto; }, "not chosen yet"},
      {"G(2)", [](Plan &p) { p.addressing = Addressing::Paged; }, "levels=direct alone"},
      {"G(2)", [](Plan &p) { p.steps = StepArithmetic::Float64, p.arithmetic = Arithmetic::Ieee; },
       "compare=numbers"},
      {"G(2)", [](Plan &p) { p.detail = Detail::Cone; }, "defers-values=no"},
      {"G(0)", [](Plan &p) { p.traversals[0].descent = Descent::Stack; }, "traversal=single"},
      {"H(2^3)", [](Plan &p) { p.traversals[0].lookUp = Loops::Whole; }, "lookup=cut"},
      {"G(2)", [](Plan &p) { p.detail = Detail::Cone, p.defersValues = false, p.traversals[0].stops = true; },
       "searched there"},
      {"R(2^3) G(2)",
       [](Plan &p) { p.detail = Detail::Cone, p.defersValues = false, p.traversals[0].stops = true; },
       "in the next stratum"},
      {"format values=apart { level 1: svdag(2) }", [](Plan &p) { p.constructions[0] = {}; }, "bricks=yes"},
      {"G(2)", [](Plan &p) { p.layout.format = "G(2)\\"; }, "in quotation marks"},
      {"G(2)", [](Plan &p) { p.layout.format = ""; }, "in quotation marks"},
  };
  for (const BrokenRule &rule : rules) {
    Plan plan = *makePlan(*parseFormat(rule.format));
    EXPECT_TRUE(parseFinishedPlan(printPlan(plan), "plan")) << rule.format;
    rule.breakIt(plan);
    EXPECT_EQ(problemOf(plan), "") << rule.problem << ": it is right, but not finished";
    Diagnostics diagnostics;
    verifyFinished(plan, diagnostics);
    ASSERT_TRUE(diagnostics.hasErrors()) << rule.problem;
    EXPECT_THAT(diagnostics.all().front().message, HasSubstr(rule.problem)) << rule.format;
  }
}

TEST(Plans, StepInDoublesWhereThatIsBest) {
  const auto stepsOf = [](const char *format, PlanOptions options, const char *precision = "exact") {
    Format parsed = *parseFormat(format);
    parsed.setAttribute(kPrecisionAttribute, precision);
    return makePlan(parsed, options)->steps;
  };
  const PlanOptions ieee = {.arithmetic = Arithmetic::Ieee};
  EXPECT_EQ(stepsOf("R(8^3) G(3)", ieee), StepArithmetic::Float64);
  EXPECT_EQ(stepsOf("R(7^3) G(3)", ieee), StepArithmetic::Float32) << "a short way";
  EXPECT_EQ(stepsOf("R(8^3) G(3)", {}), StepArithmetic::Float32) << "no doubles";
  EXPECT_EQ(stepsOf("R(8^3) G(3)", kCpuPlan), StepArithmetic::Refined) << "packets branch";
  EXPECT_EQ(stepsOf("R(8^3) G(3)", ieee, "fast"), StepArithmetic::Float32) << "fast";
}

TEST(Plans, GoDirectlyThroughTreesOfGrids) {
  const auto traversalOf = [](const char *format) { return makePlan(*parseFormat(format))->levelTraversal; };
  EXPECT_EQ(traversalOf("R(1^3) M(2^3) M(2^3)"), LevelTraversal::Direct);
  EXPECT_EQ(traversalOf("M(2^3) M(2^3)"), LevelTraversal::Nested) << "but two levels";
  EXPECT_EQ(traversalOf("R(1^3) M(2^3) M(1^3)"), LevelTraversal::Nested) << "no groups in the last";
}

TEST(Plans, LeaveATraversalThatIsAskedFor) {
  const auto traversalOf = [](const char *levels, const char *detail = "full") {
    Format format = *parseFormat("D(3^3, 15) M(2^3)");
    format.setAttribute(kLevelsAttribute, levels);
    format.setAttribute(kDetailAttribute, detail);
    return makePlan(format)->levelTraversal;
  };
  EXPECT_EQ(traversalOf("nested"), LevelTraversal::Nested);
  EXPECT_EQ(traversalOf("flat"), LevelTraversal::Flat);
  EXPECT_EQ(traversalOf("flat", "cone"), LevelTraversal::Nested) << "one loop stops at voxels alone";
}

TEST(Plans, LookPointsUpWithoutATraversal) {
  const Format format =
      *parseFormat("format precision=fast detail=cone levels=flat query=occupancy { level 1: svdag(2) }");
  const Plan plan = *makePlan(format, kCpuPlan);
  EXPECT_EQ(plan.levelTraversal, LevelTraversal::Auto);
  EXPECT_EQ(plan.steps, StepArithmetic::Float32);
  EXPECT_EQ(plan.detail, Detail::Full);
  EXPECT_EQ(plan.outputs, outputsOf(Query::Occupancy));
}

TEST(Layout, KnowsWhichCubesCanBeBuiltApart) {
  const auto sideOf = [](const char *format) { return layoutOf(*parseFormat(format)).partSide(6); };
  EXPECT_EQ(sideOf("G(9)"), 6);
  EXPECT_EQ(sideOf("G(8, 2)"), 6);
  EXPECT_EQ(sideOf("G(8, 2) R(1^3)"), 7); // Nodes of 2^1, 2^3, 2^5, 2^7 voxels a side.
  EXPECT_EQ(sideOf("R(4^3) G(4, 2)"), 6);
  EXPECT_EQ(sideOf("G(2, 2)"), 2);
}

TEST(Layout, HasRoomForTagsInItsReferences) {
  Format format = *parseFormat("D(2^3, 4) G(3)");
  EXPECT_EQ(layoutOf(format).maxWords(), std::uint64_t{1} << 32);
  format.levels[0].setAttribute(kDistancesAttribute, "in-slot");
  EXPECT_EQ(layoutOf(format).maxWords(), std::uint64_t{1} << 31);
}

} // namespace
} // namespace voxc
