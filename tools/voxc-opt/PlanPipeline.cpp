// Running passes over plans.
#include "PlanPipeline.h"

#include "voxc/Support/Stopwatch.h"

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

namespace {

std::size_t changedStrata(const Plan &before, const Plan &after) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < after.traversals.size(); ++i)
    count += !(before.traversals[i] == after.traversals[i]);
  return count;
}

} // namespace

Expected<void> runPlanPasses(Plan &plan, bool verifyEach, Instrumentation &instrumentation) {
  const auto printed = [&plan] { return printPlan(plan); };
  for (const PlanPass &pass : planPasses()) {
    if (!instrumentation.begin(pass.name, printed))
      continue;
    const Plan before = plan;
    const Stopwatch watch;
    pass.run(plan);
    instrumentation.end({.pass = pass.name,
                         .changed = !(plan == before),
                         .seconds = watch.seconds(),
                         .changedParts = changedStrata(before, plan),
                         .why = plan == before ? "what it chooses is there already" : ""},
                        printed);
    Diagnostics diagnostics;
    if (verifyEach)
      verify(plan, diagnostics);
    if (diagnostics.hasErrors())
      return Error::input("pass " + std::string(pass.name) +
                          " left a wrong plan: " + diagnostics.all().front().message);
  }
  return {};
}

} // namespace voxc::tool
