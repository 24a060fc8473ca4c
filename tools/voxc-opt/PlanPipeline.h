// The passes over plans, as voxc-opt runs them: from a format or from plan text.
#pragma once

#include "Instrumentation.h"

#include "voxc/Plan/Plan.h"
#include "voxc/Support/Error.h"

#include <string>
#include <string_view>

namespace voxc::tool {

/// What the step from the level IR to plans is called among passes.
inline constexpr std::string_view kLower = "lower";

/// True if a text is that of a plan.
bool isPlanText(std::string_view text);

/// Parses plan text. Errors come rendered, with the name of the text.
Expected<Plan> readPlan(std::string_view text, const std::string &name);

/// Runs the passes over a plan. Error: a pass left a wrong plan.
Expected<void> runPlanPasses(Plan &plan, bool verifyEach, Instrumentation &instrumentation);

} // namespace voxc::tool
