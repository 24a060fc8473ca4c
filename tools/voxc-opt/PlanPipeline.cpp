// Running passes over plans.
#include "PlanPipeline.h"

#include <algorithm>
#include <cstdio>

namespace voxc::tool {

bool isPlanText(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && text.substr(begin).starts_with("plan");
}

Expected<Plan> readPlan(std::string_view text, const std::string &name) {
  Diagnostics diagnostics;
  Plan plan = parsePlan(text, diagnostics);
  if (diagnostics.hasErrors())
    return toError(diagnostics, text, name);
  return plan;
}

bool isPlanPass(std::string_view name) {
  return name == kLower || std::ranges::find(planPasses(), name, &PlanPass::name) != planPasses().end();
}

void tellPlan(const PlanPipelineOptions &options, std::string_view pass, const Plan &plan, bool changed) {
  if (options.printAfterAll)
    std::fprintf(stderr, "-- after %s%s\n%s", std::string(pass).c_str(), changed ? "" : " (unchanged)",
                 changed ? printPlan(plan).c_str() : "");
}

Expected<void> runPlanPasses(Plan &plan, const PlanPipelineOptions &options) {
  if (options.until == kLower)
    return {};
  for (const PlanPass &pass : planPasses()) {
    const Plan before = plan;
    pass.run(plan);
    tellPlan(options, pass.name, plan, !(plan == before));
    Diagnostics diagnostics;
    if (options.verifyEach)
      verify(plan, diagnostics);
    if (diagnostics.hasErrors())
      return Error::input("pass " + std::string(pass.name) +
                          " left a wrong plan: " + diagnostics.all().front().message);
    if (pass.name == options.until)
      break;
  }
  return {};
}

} // namespace voxc::tool
