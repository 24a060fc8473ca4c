// The passes over plans, in their order.
#include "Passes.h"

#include <array>

namespace voxc {
namespace {

constexpr std::array<PlanPass, 5> kPasses = {{
    {"choose-descents", "what layers leave no choice of: a tree without any is one leaf",
     "First: what follows asks how a stratum is walked, not what it is.", chooseDescents},
    {"choose-walk",
     "nested loops, one flat loop or a direct one: as asked; else direct from 8 levels on, and where "
     "the first level tells octants above at most 8 layers of nodes, or all others, two at least, are "
     "masked grids of 4 cells a side; but nested where restart-sv, "
     "unroll-sv or detail=cone need it",
     "After the descents: they may ask for nesting.", chooseWalk},
    {"choose-steps",
     "of exact walks, where the device has doubles: in packets sums of two float32 for steps that one cannot "
     "tell, "
     "else doubles for all steps through 2^11 voxels a side and more; float32 everywhere else",
     "Anywhere: it asks for nothing that others choose.", chooseSteps},
    {"place-stack", "where the nodes above a cell are kept: as asked, if the walk keeps any",
     "After the walk, which may keep none.", placeStack},
    {"place-stops", "where a kernel of detail=cone may stop, and where it then searches a colour",
     "After the descents: a single leaf has no inner node to stop at.", placeStops},
}};

} // namespace

std::span<const PlanPass> planPasses() { return kPasses; }

Expected<Plan> makePlan(const Format &format, const PlanOptions &options) {
  Plan plan = lowerToPlan(format, options);
  for (const PlanPass &pass : planPasses()) {
    pass.run(plan);
    Diagnostics diagnostics;
    verify(plan, diagnostics);
    if (diagnostics.hasErrors())
      return Error::environment("the pass " + std::string(pass.name) +
                                " left a wrong plan, a defect of voxc: " + diagnostics.all().front().message);
  }
  return plan;
}

} // namespace voxc
