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
    plan.traversals.push_back({.descent = level.kind->isTree()
                                              ? *fromString<Descent>(level.attribute(kWalkAttribute))
                                              : Descent::Index});
  if (plan.query == Query::Occupancy) // There is no walk to choose.
    return plan;
  plan.predicate =
      format.attributes.value(kPrecisionAttribute) == "fast" ? Predicate::Float32 : Predicate::Exact;
  plan.detail = *fromString<Detail>(format.attributes.value(kDetailAttribute));
  if (options.inGroups)
    plan.stack = *fromString<Stack>(format.attributes.value(kStackAttribute));
  // One loop stops at voxels alone: cones leave no choice.
  if (plan.detail == Detail::Full)
    plan.walk = *fromString<Walk>(format.attributes.value(kLevelsAttribute));
  return plan;
}

} // namespace voxc
