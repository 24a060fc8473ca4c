// voxc-opt: runs passes over the text of either IR and prints what comes out.
#include "Descriptions.h"
#include "PlanPipeline.h"

#include "common/Command.h"
#include "common/CommandLine.h"
#include "common/ManualPage.h"
#include "frontend/FormatArgument.h"
#include "frontend/PassOptions.h"
#include "voxc/Passes/Pass.h"
#include "voxc/Support/File.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <string>

namespace {

using namespace voxc;
using namespace voxc::tool;

struct Options {
  std::string input = "-";
  PassOptions passes;
  PlanPipelineOptions plan;
  bool lower = false;
  bool timePasses = false;
  bool remarks = false;
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
  command.addFlag("--print-after-all", options.plan.printAfterAll,
                  "Print the IR to standard error after each pass");
  command.addFlag("--remarks", options.remarks,
                  "Tell of each pass that changes nothing why, on standard error");
  command.addFlag("--time-passes", options.timePasses, "Print each pass's time to standard error");
  command.addFlag("--verify-each,!--no-verify-each", options.plan.verifyEach,
                  "Verify the IR after each pass (the default)");
  command.addFlag("--lower", options.lower, "Go on to the plan, and run the passes over plans");
  command.add("--until", options.plan.until, "Stop after this pass, of either IR, or after lower")
      .takes("PASS");
  for (const DescriptionRow &row : kDescriptions)
    command.addFlag(row.flag, [&options, &row] { options.description = row.describe; }, row.summary);
  options.passes.declare(command, PassChoice::Pipeline);
}

void tellPass(const Options &options, const Pass &pass, const Format &format, PassResult result,
              double seconds) {
  const bool changed = result == PassResult::Changed;
  if (options.plan.printAfterAll)
    std::fprintf(stderr, "-- after %s%s\n%s", std::string(pass.name).c_str(), changed ? "" : " (unchanged)",
                 changed ? printIr(format).c_str() : "");
  if (options.timePasses)
    std::fprintf(stderr, "%10.6f s  %s\n", seconds, std::string(pass.name).c_str());
}

void tellMissed(const Pass &pass, const std::string &why) {
  std::fprintf(stderr, "remark: %s changes nothing: %s\n", std::string(pass.name).c_str(), why.c_str());
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

/// The passes over formats that are to run: those that were given, up to `until` if it is one of them.
std::vector<std::string> passesUntil(const Options &options) {
  std::vector<std::string> names = options.passes.names();
  const auto last = std::ranges::find(names, options.plan.until);
  if (last != names.end())
    names.erase(last + 1, names.end());
  return names;
}

/// True if the passes over plans are to run too.
Expected<bool> goesOn(const Options &options) {
  const std::string &until = options.plan.until;
  const auto names = options.passes.names();
  const bool isGiven = std::ranges::find(names, until) != names.end();
  if (!until.empty() && !isGiven && !isPlanPass(until))
    return Error::usage("there is no pass '" + until + "' to stop after; give one of those that run");
  return options.lower && !isGiven;
}

Expected<void> optimisePlan(Plan plan, const Options &options) {
  if (Expected<void> passed = runPlanPasses(plan, options.plan); !passed)
    return passed;
  std::fputs(printPlan(plan).c_str(), stdout);
  return {};
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
  if (isPlanText(*text)) {
    Expected<Plan> plan = readPlan(*text, name);
    return plan ? optimisePlan(std::move(*plan), options) : plan.error();
  }
  Expected<Format> format = parseFormat(*text, name);
  if (!format)
    return format.error();
  PipelineOptions pipeline{.order = PassOrder::AsWritten, .verifyEach = options.plan.verifyEach};
  pipeline.afterEach = [&](const Pass &pass, const Format &changed, PassResult result, double seconds) {
    tellPass(options, pass, changed, result, seconds);
  };
  if (options.remarks)
    pipeline.missed = tellMissed;
  if (Expected<void> passed = runPasses(*format, passesUntil(options), pipeline); !passed)
    return passed;
  const Expected<bool> lowers = goesOn(options);
  if (!lowers)
    return lowers.error();
  if (*lowers) {
    Plan plan = lowerToPlan(*format);
    tellPlan(options.plan, kLower, plan, true);
    return optimisePlan(std::move(plan), options);
  }
  std::fputs(printIr(*format).c_str(), stdout);
  return {};
}

} // namespace

int main(int argc, char **argv) {
  const CommandLine command("voxc-opt", "Runs passes over the level IR or the plan of a format");
  Options options;
  declare(command, options);
  return runTool(command, argc, argv, [&] { return optimise(options); });
}
