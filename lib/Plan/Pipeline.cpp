// The passes over plans, in their order.
#include "Passes.h"

#include <array>
#include <cstdlib>

namespace voxc {
namespace {

constexpr std::array<PlanPass, 2> kPasses = {{
    {"choose-descents", "what slots and layers leave no choice of: a table is probed, a tree without layers is one leaf",
     "First: what follows asks how a stratum is walked, not what it is.", chooseDescents},
    {"place-stops", "where a kernel of detail=cone may stop, and where it then searches a colour",
     "After the descents: a single leaf has no inner node to stop at.", placeStops},
}};

} // namespace

std::span<const PlanPass> planPasses() { return kPasses; }

Plan makePlan(const Format &format, const PlanOptions &options) {
  Plan plan = lowerToPlan(format, options);
  for (const PlanPass &pass : planPasses())
    pass.run(plan);
  return plan;
}

} // namespace voxc
