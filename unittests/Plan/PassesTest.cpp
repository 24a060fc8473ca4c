// Each pass over plans alone, from the text of a plan and back.
#include "voxc/Plan/Plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace voxc {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// What a pass makes of a plan, which it leaves right.
std::string after(std::string_view name, const std::string &text) {
  Diagnostics diagnostics;
  Plan plan = parsePlan(text, diagnostics);
  const auto pass = std::ranges::find(planPasses(), name, &PlanPass::name);
  if (diagnostics.hasErrors() || pass == planPasses().end())
    return render(diagnostics, text, name);
  pass->run(plan);
  verify(plan, diagnostics);
  return diagnostics.hasErrors() ? render(diagnostics, text, name) : printPlan(plan);
}

/// A grid above a tree, with these fields of the plan and of the tree.
std::string gridAndTree(const std::string &fields, const std::string &ofTree = "") {
  return "plan \"R(2, 2, 2) G(2)\" " + fields +
         " { stratum 1: raw dense(2, 2, 2) cell=2 "
         "stratum 2: svdag packed(1, 1, 1) depth=2 traversal=stack " +
         ofTree + " }";
}

/// A hashed grid above a grid of voxels.
std::string twoGrids(const std::string &fields) {
  return "plan \"H(1, 1, 1) R(1, 1, 1)\" " + fields +
         " { stratum 1: hash hashed(1, 1, 1) cell=1 stratum 2: raw dense(1, 1, 1) }";
}

TEST(PlanPasses, ChooseComparisonByTheNumbersThereAre) {
  EXPECT_THAT(after("choose-comparison", gridAndTree("levels=nested")), Not(HasSubstr("compare")));
  EXPECT_THAT(after("choose-comparison", gridAndTree("packing=packets")), HasSubstr("compare=numbers"));
  EXPECT_THAT(after("choose-comparison", gridAndTree("arithmetic=ieee steps=float64")),
              HasSubstr("compare=numbers"));
}

TEST(PlanPasses, ChooseSpeculationOfDirectExactTraversals) {
  EXPECT_THAT(after("choose-speculation", gridAndTree("levels=direct")), HasSubstr("speculative=yes"));
  EXPECT_THAT(after("choose-speculation", gridAndTree("levels=direct precision=fast")),
              Not(HasSubstr("speculative")));
  EXPECT_THAT(after("choose-speculation", gridAndTree("levels=flat")), Not(HasSubstr("speculative")));
}

TEST(PlanPasses, ChooseGapFacesWhereLookUpsWait) {
  EXPECT_THAT(after("choose-span-faces", gridAndTree("levels=direct")), HasSubstr("span-faces=lookup"));
  EXPECT_THAT(after("choose-span-faces", gridAndTree("levels=direct packing=packets")),
              Not(HasSubstr("faces")));
  EXPECT_THAT(after("choose-span-faces", gridAndTree("levels=nested")), Not(HasSubstr("faces")));
}

TEST(PlanPasses, ChooseNarrowPacketsForSeveralLoops) {
  EXPECT_THAT(after("choose-packet-width", gridAndTree("levels=nested packing=packets")),
              HasSubstr("packet-width=narrow"));
  EXPECT_THAT(after("choose-packet-width", gridAndTree("levels=direct packing=packets")),
              Not(HasSubstr("packet-width")));
  EXPECT_THAT(after("choose-packet-width", gridAndTree("levels=nested")), Not(HasSubstr("packet-width")));
}

TEST(PlanPasses, DeferValuesUnlessConesStopElsewhere) {
  EXPECT_THAT(after("defer-values", gridAndTree("detail=cone")), HasSubstr("defers-values=no"));
  EXPECT_THAT(after("defer-values", gridAndTree("detail=cone query=any voxel=no t=no colour=no")),
              Not(HasSubstr("defers-values")));
  EXPECT_THAT(after("defer-values", gridAndTree("")), Not(HasSubstr("defers-values")));
}

TEST(PlanPasses, DropValuesThatNobodyAsksFor) {
  EXPECT_THAT(after("drop-values", gridAndTree("colour=no")), HasSubstr("traversal=stack reads-values=no"));
  EXPECT_THAT(after("drop-values", gridAndTree("colour=no")), Not(HasSubstr("cell=2 reads-values")));
  EXPECT_THAT(after("drop-values", gridAndTree("")), Not(HasSubstr("reads-values")));
}

TEST(PlanPasses, GuardLookUpsThatLoopOnDevicesThatCut) {
  EXPECT_THAT(after("guard-lookups", twoGrids("loops=cut")),
              AllOf(HasSubstr("cell=1 lookup=cut"), Not(HasSubstr("raw dense(1, 1, 1) lookup"))));
  EXPECT_THAT(after("guard-lookups", twoGrids("")), Not(HasSubstr("lookup=cut")));
  EXPECT_THAT(after("guard-lookups", twoGrids("loops=cut query=occupancy t=no colour=no")),
              Not(HasSubstr("lookup=cut")));
}

TEST(PlanPasses, ChooseVoxelStepsOfNestedTraversalsThroughVoxels) {
  EXPECT_THAT(after("choose-voxel-steps", twoGrids("levels=nested")),
              AllOf(HasSubstr("dense(1, 1, 1) voxel-steps=yes"), Not(HasSubstr("cell=1 voxel-steps"))));
  EXPECT_THAT(after("choose-voxel-steps", twoGrids("levels=direct")), Not(HasSubstr("voxel-steps")));
}

TEST(PlanPasses, ChooseBricksBelowTrees) {
  EXPECT_THAT(after("choose-bricks", gridAndTree("")), HasSubstr("traversal=stack bricks=yes"));
  EXPECT_THAT(after("choose-bricks", twoGrids("")), Not(HasSubstr("bricks")));
}

TEST(PlanPasses, ChooseToLookAheadInBricksOfNodesThatAreCompared) {
  EXPECT_THAT(after("choose-look-ahead", gridAndTree("", "bricks=yes")),
              HasSubstr("bricks=yes looks-ahead=yes"));
  EXPECT_THAT(after("choose-look-ahead", gridAndTree("")), Not(HasSubstr("looks-ahead")));
  EXPECT_THAT(after("choose-look-ahead", "plan \"S(2)\" { stratum 1: svo siblings(1, 1, 1) depth=2 "
                                         "traversal=stack bricks=yes }"),
              Not(HasSubstr("looks-ahead")));
}

} // namespace
} // namespace voxc
