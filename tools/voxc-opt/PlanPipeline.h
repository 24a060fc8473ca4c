// The passes over plans, as voxc-opt runs them: from a format or from plan text, up to any of them.
#pragma once

#include "voxc/Plan/Plan.h"
#include "voxc/Support/Error.h"

#include <string>
#include <string_view>

namespace voxc::tool {

/// What the step from the level IR to plans is called among passes.
inline constexpr std::string_view kLower = "lower";

struct PlanPipelineOptions {
  std::string until; ///< The last pass to run; "": all of them.
  bool printAfterAll = false;
  bool verifyEach = true;
};

/// True if a text is that of a plan.
bool isPlanText(std::string_view text);

/// Parses plan text. Errors come rendered, with the name of the text.
Expected<Plan> readPlan(std::string_view text, const std::string &name);

/// Runs the passes over a plan. Error: a pass left a wrong plan.
Expected<void> runPlanPasses(Plan &plan, const PlanPipelineOptions &options);

/// True if there is a pass over plans of this name, or it is `kLower`.
bool isPlanPass(std::string_view name);

/// Prints a plan as it is after a pass, if that is asked for.
void tellPlan(const PlanPipelineOptions &options, std::string_view pass, const Plan &plan, bool changed);

} // namespace voxc::tool
