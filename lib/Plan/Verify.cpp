// The rules of plans: those of the layout, and that each stratum is walked in a way that it has.
#include "voxc/Plan/Plan.h"

namespace voxc {

void verify(const Plan &plan, Diagnostics &diagnostics, const std::vector<SourceRange> &ranges) {
  verify(plan.layout, diagnostics, ranges);
  if (plan.traversals.size() != plan.layout.strata.size())
    return diagnostics.error({}, "a plan says of each stratum how it is walked");
  if (const std::string_view problem = problemOf({plan.query, plan.outputs, plan.bounded}); !problem.empty())
    diagnostics.error({}, "the plan " + std::string(problem));
  if (plan.query == Query::Occupancy &&
      (plan.walk != Walk::Auto || plan.steps != Steps::Float32 || plan.detail != Detail::Full))
    diagnostics.error({}, "a point is looked up without a walk, its steps and its detail");
  if (plan.outputs.index && (plan.layout.values != Values::Apart || plan.detail != Detail::Full))
    diagnostics.error({},
                      "the numbers of voxels are counted where their values stand apart, with detail=full");
  if (plan.stack == Stack::Shared && plan.packing == Packing::Packets)
    diagnostics.error({}, "rays in packets have no memory of a group: their stack is private");
  const bool isOneLoop = plan.walk == Walk::Flat || plan.walk == Walk::Direct;
  if (isOneLoop && plan.detail == Detail::Cone)
    diagnostics.error({}, "one loop for all levels stops at voxels alone");
  if (plan.addressing == Addressing::Paged && plan.query == Query::Occupancy)
    diagnostics.error({}, "pages that are not here are what rays wait for, not points");
  if (plan.bounded && plan.detail == Detail::Cone)
    diagnostics.error({}, "a walk between bounds stops at voxels alone");
  if (plan.steps != Steps::Float32 &&
      (plan.arithmetic != Arithmetic::Ieee || plan.precision != Precision::Exact))
    diagnostics.error({}, "exact walks alone take doubles, with arithmetic=ieee");
  for (std::size_t i = 0; i < plan.traversals.size(); ++i) {
    const Stratum &stratum = plan.layout.strata[i];
    const Traversal &traversal = plan.traversals[i];
    const SourceRange range = i < ranges.size() ? ranges[i] : SourceRange{};
    const std::string number = "stratum " + std::to_string(i + 1) + ": ";
    if (stratum.isGrid() != (traversal.descent == Descent::Index))
      diagnostics.error(range, number + "a grid is walked by index, and nothing else is");
    if (isOneLoop && (traversal.descent == Descent::Restart || traversal.descent == Descent::Unrolled))
      diagnostics.error(range, number + "one loop for all levels goes down trees in its own way");
    if (traversal.descent == Descent::Single && stratum.depth != 0)
      diagnostics.error(range, number + "a tree with layers is more than a single cell");
    if ((traversal.stops || traversal.sampled) && plan.detail == Detail::Full)
      diagnostics.error(range, number + "walks stop above voxels with detail=cone alone");
  }
}

} // namespace voxc
