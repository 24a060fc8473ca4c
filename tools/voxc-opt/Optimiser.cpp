// Running a pipeline over an input, part by part.
#include "Optimiser.h"

#include "ExpectedDiagnostics.h"
#include "SplitInput.h"

#include "voxc/Passes/Pass.h"

#include <memory>

namespace voxc::tool {

Expected<void> Optimiser::run(const SourceText &input, std::string &output) {
  if (!options_.splits)
    return runPart(input, output);
  Expected<void> result;
  for (const SourceText &part : splitInput(input)) {
    Expected<void> done = runPart(part, output);
    if (done)
      continue;
    if (result)
      result = done;
    else if (result.error().kind == done.error().kind)
      result = Error{done.error().kind, result.error().message + "\n" + done.error().message};
  }
  return result;
}

Expected<void> Optimiser::runPart(const SourceText &part, std::string &output) {
  found_.clear();
  instrumentation_.beginInput(part, firstWord(part.text), options_.verifiesDiagnostics ? &found_ : nullptr);
  if (options_.verifiesDiagnostics)
    return runExpecting(part, output);
  const auto text = VOXC_TRY(optimise(part));
  output += (output.empty() ? "" : std::string(kSplitMarker) + "\n") + text;
  return {};
}

Expected<void> Optimiser::runExpecting(const SourceText &part, std::string &output) {
  const auto expected = VOXC_TRY(ExpectedDiagnostics::read(part));
  const Expected<std::string> text = optimise(part);
  if (!text && found_.empty()) // It is no diagnostic of the input.
    return text.error();
  for (Diagnostic &diagnostic : found_)
    if (diagnostic.range == SourceRange{}) // It speaks of the whole.
      diagnostic.range = firstWord(part.text);
  if (text)
    output += (output.empty() ? "" : std::string(kSplitMarker) + "\n") + *text;
  return expected.compare(found_);
}

Expected<std::string> Optimiser::optimise(const SourceText &part) {
  const bool isPlan = isPlanText(part.text);
  const auto pipeline = VOXC_TRY(pipelineFor(pipeline_, isPlan));
  VOXC_TRY(instrumentation_.check(pipeline.names()));
  if (!isPlan)
    return optimiseFormat(part, pipeline);
  Diagnostics diagnostics;
  Plan plan = parsePlan(part.text, diagnostics);
  keep(diagnostics);
  if (diagnostics.hasErrors())
    return toError(diagnostics, part);
  return optimisePlan(std::move(plan), pipeline);
}

Expected<std::string> Optimiser::optimiseFormat(const SourceText &part, const PassPipeline &pipeline) {
  Diagnostics diagnostics;
  const SourceRange word = firstWord(part.text);
  const bool isIr = part.text.compare(word.begin, word.end - word.begin, "format") == 0;
  Format format = isIr ? parseIr(part.text, diagnostics) : parseFormat(part.text, diagnostics);
  keep(diagnostics);
  if (diagnostics.hasErrors())
    return toError(diagnostics, part);
  format.source = std::make_shared<const SourceText>(part);
  const PipelineOptions options = passOptions();
  VOXC_TRY(runPasses(format, pipeline.ofFormats, options, PassOrder::AsWritten));
  if (pipeline.lowers)
    if (std::optional<Plan> plan = lowerToPlan(format, {}, options))
      return optimisePlan(std::move(*plan), pipeline);
  return printIr(format);
}

Expected<std::string> Optimiser::optimisePlan(Plan plan, const PassPipeline &pipeline) {
  VOXC_TRY(runPlanPasses(plan, pipeline.ofPlans, passOptions()));
  return printPlan(plan);
}

PipelineOptions Optimiser::passOptions() {
  PipelineOptions options = instrumentation_.hooks();
  options.verifyEach = options_.verifyEach;
  options.onErrors = [this](const Diagnostics &diagnostics) { keep(diagnostics); };
  return options;
}

void Optimiser::keep(const Diagnostics &diagnostics) {
  for (const Diagnostic &diagnostic : diagnostics.all())
    found_.push_back(diagnostic);
}

} // namespace voxc::tool
