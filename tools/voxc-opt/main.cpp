// voxc-opt: runs passes over the text of either IR and prints what comes out.
#include "Descriptions.h"
#include "Instrumentation.h"
#include "PlanPipeline.h"

#include "common/Command.h"
#include "common/CommandLine.h"
#include "common/ManualPage.h"
#include "frontend/FormatArgument.h"
#include "frontend/PassOptions.h"
#include "voxc/Passes/Pass.h"
#include "voxc/Support/File.h"
#include "voxc/Support/Stopwatch.h"

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace voxc;
using namespace voxc::tool;

struct Options {
  std::string input = "-";
  PassOptions passes;
  InstrumentationOptions instrumentation;
  bool verifyEach = true;
  bool lower = false;
  std::string (*description)() = nullptr; ///< To be printed instead.
};

struct DescriptionRow {
  const char *flag;
  const char *summary;
  std::string (*describe)();
};

constexpr DescriptionRow kDescriptions[] = {
    {"--help-passes", "Describe the passes and exit", describePasses},
    {"--help-plan-passes", "Describe the passes over plans, as a table in Markdown, and exit",
     describePlanPasses},
    {"--help-levels", "Describe the level kinds and exit", describeLevels},
    {"--help-attributes", "Describe the attributes, as a table in Markdown, and exit", describeAttributes},
};

void declare(const CommandLine &command, Options &options) {
  command.addVersion(versionText());
  addManual(command);
  command
      .add("INPUT", options.input,
           "A format string, or a file with one, with IR or with a plan; - for standard input")
      .takes("")
      .showsDefault();
  options.instrumentation.declare(command);
  command.addFlag("--verify-each,!--no-verify-each", options.verifyEach,
                  "Verify the IR after each pass (the default)");
  command.addFlag("--lower", options.lower, "Go on to the plan, and run the passes over plans");
  for (const DescriptionRow &row : kDescriptions)
    command.addFlag(row.flag, [&options, &row] { options.description = row.describe; }, row.summary);
  options.passes.declare(command, PassChoice::Pipeline);
}

std::size_t changedLevels(const PassRun &run) {
  if (run.before.levels.size() != run.after.levels.size())
    return run.after.levels.size();
  std::size_t count = 0;
  for (std::size_t i = 0; i < run.after.levels.size(); ++i)
    count += !(run.before.levels[i] == run.after.levels[i]);
  return count;
}

/// A format string has brackets, and no file has its name.
bool isFormatString(const std::string &input) {
  std::error_code ignored;
  return input.find('(') != std::string::npos && !std::filesystem::exists(input, ignored);
}

Expected<std::string> readText(const std::string &input) {
  if (input == "-")
    return std::string{std::istreambuf_iterator<char>(std::cin), {}};
  return isFormatString(input) ? Expected<std::string>(input) : readTextFile(input);
}

PipelineOptions pipelineOf(const Options &options, Instrumentation &instrumentation) {
  PipelineOptions pipeline{.order = PassOrder::AsWritten, .verifyEach = options.verifyEach};
  pipeline.beforeEach = [&](const Pass &pass, const Format &format) {
    return instrumentation.begin(pass.name, [&] { return printIr(format); });
  };
  pipeline.afterEach = [&](const PassRun &run) {
    instrumentation.end({.pass = run.pass.name,
                         .changed = run.result == PassResult::Changed,
                         .seconds = run.seconds,
                         .changedParts = changedLevels(run),
                         .why = run.why},
                        [&] { return printIr(run.after); });
  };
  return pipeline;
}

/// The passes of both IRs that options may name.
std::vector<std::string_view> passesOf(const std::vector<std::string> &given, bool lowers) {
  std::vector<std::string_view> names;
  for (const std::string &name : given)
    if (const Pass *pass = findPass(name))
      names.push_back(pass->name);
  if (lowers) {
    names.push_back(kLower);
    for (const PlanPass &pass : planPasses())
      names.push_back(pass.name);
  }
  return names;
}

Expected<void> optimisePlan(Plan plan, const Options &options, Instrumentation &instrumentation) {
  if (Expected<void> passed = runPlanPasses(plan, options.verifyEach, instrumentation); !passed)
    return passed;
  std::fputs(printPlan(plan).c_str(), stdout);
  return instrumentation.finish();
}

Expected<void> optimiseFormat(Format format, const Options &options, Instrumentation &instrumentation) {
  if (Expected<void> passed = runPasses(format, options.passes.names(), pipelineOf(options, instrumentation));
      !passed)
    return passed;
  if (options.lower && instrumentation.begin(kLower, [&] { return printIr(format); })) {
    const Stopwatch watch;
    Plan plan = lowerToPlan(format);
    instrumentation.end({.pass = kLower,
                         .changed = true,
                         .seconds = watch.seconds(),
                         .changedParts = plan.layout.strata.size()},
                        [&] { return printPlan(plan); });
    return optimisePlan(std::move(plan), options, instrumentation);
  }
  std::fputs(printIr(format).c_str(), stdout);
  return instrumentation.finish();
}

Expected<void> optimise(const Options &options) {
  if (options.description) {
    std::fputs(options.description().c_str(), stdout);
    return {};
  }
  const std::string name = options.input == "-"            ? "<stdin>"
                           : isFormatString(options.input) ? "format"
                                                           : options.input;
  const Expected<std::string> text = readText(options.input);
  if (!text)
    return text.error();
  const bool isPlan = isPlanText(*text);
  Instrumentation instrumentation(options.instrumentation);
  if (auto known = instrumentation.check(passesOf(options.passes.names(), isPlan || options.lower)); !known)
    return known;
  if (isPlan) {
    Expected<Plan> plan = readPlan(*text, name);
    return plan ? optimisePlan(std::move(*plan), options, instrumentation) : plan.error();
  }
  Expected<Format> format = parseFormat(*text, name);
  return format ? optimiseFormat(std::move(*format), options, instrumentation) : format.error();
}

} // namespace

int main(int argc, char **argv) {
  const CommandLine command("voxc-opt", "Runs passes over the level IR or the plan of a format");
  Options options;
  declare(command, options);
  return runTool(command, argc, argv, [&] { return optimise(options); });
}
