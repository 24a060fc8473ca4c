// Making a plan: the one place where a format's parameters and attributes turn into choices.
#include "voxc/Plan/Plan.h"

namespace voxc {
namespace {

Descent descentOf(const Level &level) {
  if (level.kind->arrangement == Arrangement::Grid)
    return level.parameter(ParameterRole::Reach) > 0 ? Descent::Distance : Descent::Index;
  if (level.parameter(ParameterRole::Side) == 0)
    return Descent::Single;
  return level.attribute(kWalkAttribute) == "restart" ? Descent::Restart : Descent::Stack;
}

Sharing sharingOf(const Level &level) {
  for (const AttributeKind *attribute : level.kind->attributes) {
    if (attribute == &kDedupAttribute)
      return level.attribute(kDedupAttribute) == "level" ? Sharing::Level : Sharing::SubVolume;
    if (attribute == &kShareAttribute)
      return level.attribute(kShareAttribute) == "level" ? Sharing::Level : Sharing::None;
  }
  return Sharing::None;
}

} // namespace

Plan makePlan(const Format &format, const PlanOptions &options) {
  Plan plan;
  plan.format = format;
  plan.addressing = options.addressing;
  plan.predicate =
      format.attributes.value(kPrecisionAttribute) == "fast" ? Predicate::Float32 : Predicate::Exact;
  for (std::size_t i = 0; i < format.levels.size(); ++i) {
    const Level &level = format.levels[i];
    plan.levels.push_back({static_cast<int>(i) + 1, level.kind, level.log2Size(), format.log2CellSide(i),
                           level.parameter(ParameterRole::Reach), descentOf(level), sharingOf(level)});
  }
  return plan;
}

} // namespace voxc
