// Plans as text.
#include "PlanFields.h"

#include "voxc/Layout/SlotKind.h"

namespace voxc {
namespace {

template <typename Owner> std::string fieldsOf(const Owner &owner, std::span<const Field<Owner>> fields) {
  std::string text;
  for (const Field<Owner> &field : fields)
    if (const std::string value = field.isOf(owner) ? field.print(owner) : ""; !value.empty())
      text += " " + std::string(field.name) + "=" + value;
  return text;
}

std::string triple(Int3 v) {
  return "(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ")";
}

} // namespace

std::string printPlan(const Plan &plan) {
  std::string text = "plan \"" + plan.layout.format + "\"" + fieldsOf(plan, planFields()) + " {\n";
  for (std::size_t i = 0; i < plan.layout.strata.size(); ++i) {
    const PlannedStratum stratum{plan.layout.strata[i], plan.traversals[i], plan.constructions[i]};
    text += "  stratum " + std::to_string(i + 1) + ": " + stratum.level + " " +
            std::string(stratum.slots->name) + triple(stratum.log2Shape) +
            fieldsOf(stratum, stratumFields()) + "\n";
  }
  return text + "}\n";
}

} // namespace voxc
