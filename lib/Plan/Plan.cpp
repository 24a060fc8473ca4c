// Making a plan: the one place where a format's parameters and attributes turn into choices.
#include "voxc/Plan/Plan.h"

namespace voxc {
namespace {

Descent descentOf(const Level &level) {
  if (level.kind->arrangement == Arrangement::Grid)
    return level.parameter(ParameterRole::Reach) > 0 ? Descent::Distance : Descent::Index;
  if (level.parameter(ParameterRole::Side) == 0)
    return Descent::Single;
  const std::string_view walk = level.attribute(kWalkAttribute);
  return walk == "restart" ? Descent::Restart : walk == "unrolled" ? Descent::Unrolled : Descent::Stack;
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

/// Cells of a grid in which a colour is searched, as log2: more would take longer than the walk that is
/// saved.
constexpr int kLog2SearchedCells = 12;

bool isSearchable(const LevelPlan &level) {
  const Int3 size = level.log2Size;
  return level.kind->arrangement == Arrangement::Tree || size.x + size.y + size.z <= kLog2SearchedCells;
}

/// Decides from the last level up where a walk may stop: only above what can be searched for a colour.
void planStops(Plan &plan) {
  bool searchableBelow = true;
  for (std::size_t i = plan.levels.size(); i-- > 0;) {
    LevelPlan &level = plan.levels[i];
    const bool hasInnerNodes =
        level.kind->arrangement == Arrangement::Tree && level.descent != Descent::Single;
    level.stops = searchableBelow && (i + 1 < plan.levels.size() || hasInnerNodes);
    searchableBelow = searchableBelow && isSearchable(level);
    level.sampled = (hasInnerNodes && level.stops) || (i > 0 && searchableBelow);
  }
}

} // namespace

Plan makePlan(const Format &format, const PlanOptions &options) {
  Plan plan;
  plan.format = format;
  plan.addressing = options.addressing;
  plan.predicate =
      format.attributes.value(kPrecisionAttribute) == "fast" ? Predicate::Float32 : Predicate::Exact;
  plan.detail = format.attributes.value(kDetailAttribute) == "cone" ? Detail::Cone : Detail::Full;
  for (std::size_t i = 0; i < format.levels.size(); ++i) {
    const Level &level = format.levels[i];
    plan.levels.push_back({static_cast<int>(i) + 1, level.kind, level.log2Size(), format.log2CellSide(i),
                           level.parameter(ParameterRole::Reach), descentOf(level), sharingOf(level)});
  }
  if (plan.detail == Detail::Cone)
    planStops(plan);
  return plan;
}

} // namespace voxc
