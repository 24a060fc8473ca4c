// voxc-opt: runs passes over the text of either IR and prints what comes out.
#include "Descriptions.h"
#include "Instrumentation.h"
#include "Optimiser.h"
#include "PassPipeline.h"

#include "common/Command.h"
#include "common/CommandLine.h"
#include "common/ManualPage.h"
#include "frontend/FormatArgument.h"
#include "frontend/PassOptions.h"
#include "voxc/Support/File.h"

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace voxc;
using namespace voxc::tool;

struct Options {
  std::string input = "-";
  PassOptions passes;
  std::optional<std::string> pipeline; ///< As text.
  InstrumentationOptions instrumentation;
  OptimiserOptions optimiser;
  bool lower = false;
  bool dumpsPipeline = false;
  std::string (*description)() = nullptr; ///< To be printed instead.
};

struct DescriptionRow {
  const char *flag;
  const char *summary;
  std::string (*describe)();
};

constexpr DescriptionRow kDescriptions[] = {
    {"--print-passes", "List the passes of both IRs with their options and exit", listPasses},
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
  command.addFlag("--verify-each,!--no-verify-each", options.optimiser.verifyEach,
                  "Verify the IR after each pass (the default)");
  command.addFlag("--split-input-file", options.optimiser.splits,
                  "Run each part of the input by itself; parts are divided by lines '// -----'");
  command.addFlag("--verify-diagnostics", options.optimiser.verifiesDiagnostics,
                  "Fail unless the diagnostics are those that comments expect: // expected-error @+1 {{part "
                  "of the message}}");
  command.addFlag("--lower", options.lower, "Go on to the plan, and run the passes over plans");
  command
      .add("--pass-pipeline", options.pipeline,
           "Run these passes, of both IRs, in place of those that flags choose: "
           "'merge-grids,short-pointers{bits=20},lower,choose-traversal'")
      .takes("TEXT");
  command.addFlag("--dump-pass-pipeline", options.dumpsPipeline,
                  "Print the pipeline as text to standard error");
  for (const DescriptionRow &row : kDescriptions)
    command.addFlag(row.flag, [&options, &row] { options.description = row.describe; }, row.summary);
  options.passes.declare(command, PassChoice::Pipeline);
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

Expected<PassPipeline> chosenPipeline(const Options &options) {
  const std::vector<std::string> flags = options.passes.names();
  if (!options.pipeline)
    return pipelineOf(flags, options.lower);
  if (options.lower || !flags.empty())
    return Error::usage("found --pass-pipeline beside " + (options.lower ? "--lower" : "--" + flags.front()) +
                        "; write the passes into the pipeline");
  return parsePipeline(*options.pipeline);
}

Expected<void> optimise(const Options &options) {
  if (options.description) {
    std::fputs(options.description().c_str(), stdout);
    return {};
  }
  const auto pipeline = VOXC_TRY(chosenPipeline(options));
  if (options.dumpsPipeline)
    std::fprintf(stderr, "%s\n", pipeline.text().c_str());
  const auto text = VOXC_TRY(readText(options.input));
  const std::string name = options.input == "-"            ? "<stdin>"
                           : isFormatString(options.input) ? "format"
                                                           : options.input;
  Instrumentation instrumentation(options.instrumentation);
  std::string output;
  const Expected<void> done =
      Optimiser(options.optimiser, pipeline, instrumentation).run({name, text}, output);
  std::fputs(output.c_str(), stdout);
  const Expected<void> written = instrumentation.finish();
  return done ? written : done;
}

} // namespace

int main(int argc, char **argv) {
  const CommandLine command("voxc-opt", "Runs passes over the level IR or the plan of a format");
  Options options;
  declare(command, options);
  return runTool(command, argc, argv, [&] { return optimise(options); });
}
