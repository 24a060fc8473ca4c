// From the level IR to the plan: strata, and what the attributes ask of the kernel.
#include "voxc/Plan/Plan.h"

namespace voxc {

Plan lowerToPlan(const Format &format, const PlanOptions &options) {
  Plan plan;
  plan.layout = layoutOf(format);
  plan.addressing = options.addressing;
  plan.loops = options.loops;
  plan.arithmetic = options.arithmetic;
  plan.packing = options.packing;
  const Question question = options.question.value_or(questionOf(format));
  plan.query = question.query;
  plan.outputs = question.outputs;
  plan.bounded = question.bounds;
  for (const Level &level : format.levels)
    plan.traversals.push_back({.descent = level.kind->isTree() ? level.get(kTraversalAttribute) : Descent{}});
  plan.constructions.resize(format.levels.size());
  if (plan.isOfPoints()) // There is no traversal to choose.
    return plan;
  plan.precision = format.attributes.get(kPrecisionAttribute);
  plan.detail = format.attributes.get(kDetailAttribute);
  if (options.inGroups)
    plan.stack = format.attributes.get(kStackAttribute);
  // One loop stops at voxels alone: cones leave no choice.
  if (!plan.stopsAboveVoxels())
    plan.levelTraversal = format.attributes.get(kLevelsAttribute);
  return plan;
}

} // namespace voxc
