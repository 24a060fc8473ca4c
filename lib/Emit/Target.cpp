// What each target asks of a plan: as the options say that plans are made with for it (voxc/Plan/Plan.h).
#include "voxc/Emit/Emit.h"

#include <array>
#include <string_view>

namespace voxc {
namespace {

struct TargetRule {
  std::string_view field; ///< As plan text has it.
  bool (*holds)(const Plan &plan);
};

constexpr TargetRule kDeviceRules[] = {
    {"packing=device", [](const Plan &plan) { return plan.packing == Packing::Device; }},
};

constexpr TargetRule kProcessorRules[] = {
    {"packing=packets", [](const Plan &plan) { return plan.packing == Packing::Packets; }},
    {"loops=whole", [](const Plan &plan) { return plan.loops == Loops::Whole; }},
};

constexpr TargetRule kFirstHitRules[] = {
    {"query=closest", [](const Plan &plan) { return isOfHits(plan.query); }},
    {"face=yes, with voxel, t and colour",
     [](const Plan &plan) { return plan.outputs == Outputs{.face = true}; }},
    {"detail=full", [](const Plan &plan) { return !plan.stopsAboveVoxels(); }},
    {"loops=whole", [](const Plan &plan) { return plan.loops == Loops::Whole; }},
    {"packing=device", [](const Plan &plan) { return plan.packing == Packing::Device; }},
    {"addressing=buffer", [](const Plan &plan) { return plan.addressing == Addressing::Buffer; }},
    {"arithmetic=any", [](const Plan &plan) { return plan.arithmetic == Arithmetic::Any; }},
    {"stack=private", [](const Plan &plan) { return !plan.sharesStack(); }},
};

constexpr TargetRule kBounds = {"bounds=yes", [](const Plan &plan) { return plan.bounded; }};

struct TargetKind {
  std::string_view what;
  std::span<const TargetRule> rules;
  bool isBounded;
};

/// In the order of `EmitTarget`.
constexpr std::array<TargetKind, 4> kTargets = {{
    {"a kernel for devices", kDeviceRules, false},
    {"a kernel for this processor", kProcessorRules, false},
    {"functions for others", kFirstHitRules, true},
    {"functions for others", kFirstHitRules, false},
}};

void addMissing(std::string &fields, const TargetRule &rule, const Plan &plan) {
  if (!rule.holds(plan))
    fields += (fields.empty() ? "" : ", ") + std::string(rule.field);
}

} // namespace

std::string problemOf(const Plan &plan, EmitTarget target) {
  const TargetKind &kind = kTargets[static_cast<std::size_t>(target)];
  std::string fields;
  for (const TargetRule &rule : kind.rules)
    addMissing(fields, rule, plan);
  if (kind.isBounded)
    addMissing(fields, kBounds, plan);
  return fields.empty() ? "" : std::string(kind.what) + " would be printed of a plan with " + fields;
}

} // namespace voxc
