// voxc-opt: runs passes over IR text and prints the IR that comes out.
#include "Descriptions.h"

#include "common/Command.h"
#include "frontend/FormatArgument.h"
#include "frontend/PassOptions.h"
#include "voxc/Passes/Pass.h"

#include <cstdio>
#include <string>

namespace {

using namespace voxc;
using namespace voxc::tool;

struct Options {
  std::string input = "-";
  PassOptions passes;
  bool printAfterAll = false;
  bool timePasses = false;
  bool verifyEach = true;
  std::string (*description)() = nullptr; ///< To be printed instead.
};

struct DescriptionRow {
  const char *flag;
  const char *summary;
  std::string (*describe)();
};

constexpr DescriptionRow kDescriptions[] = {
    {"--help-passes", "Describe the passes and exit", describePasses},
    {"--help-levels", "Describe the level kinds and exit", describeLevels},
    {"--help-attributes", "Describe the attributes, as a table in Markdown, and exit", describeAttributes},
};

void declare(CLI::App &app, Options &options) {
  app.set_version_flag("--version", versionText());
  app.add_option("INPUT", options.input, "File with IR or a format string; - for standard input")
      ->type_name("")
      ->capture_default_str();
  app.add_flag("--print-after-all", options.printAfterAll, "Print the IR to standard error after each pass");
  app.add_flag("--time-passes", options.timePasses, "Print each pass's time to standard error");
  app.add_flag("--verify-each,!--no-verify-each", options.verifyEach,
               "Verify the IR after each pass (the default)");
  for (const DescriptionRow &row : kDescriptions)
    app.add_flag_callback(row.flag, [&options, &row] { options.description = row.describe; }, row.summary);
  options.passes.declare(app, PassChoice::All);
}

void tellPass(const Options &options, const Pass &pass, const Format &format, PassResult result,
              double seconds) {
  const bool changed = result == PassResult::Changed;
  if (options.printAfterAll)
    std::fprintf(stderr, "-- after %s%s\n%s", std::string(pass.name).c_str(), changed ? "" : " (unchanged)",
                 changed ? printIr(format).c_str() : "");
  if (options.timePasses)
    std::fprintf(stderr, "%10.6f s  %s\n", seconds, std::string(pass.name).c_str());
}

Expected<void> optimise(const Options &options) {
  if (options.description) {
    std::fputs(options.description().c_str(), stdout);
    return {};
  }
  Expected<Format> format = readFormatFile(options.input);
  if (!format)
    return format.error();
  PipelineOptions pipeline{.verifyEach = options.verifyEach, .afterEach = {}};
  pipeline.afterEach = [&](const Pass &pass, const Format &changed, PassResult result, double seconds) {
    tellPass(options, pass, changed, result, seconds);
  };
  if (Expected<void> passed = options.passes.apply(*format, pipeline); !passed)
    return passed;
  std::fputs(printIr(*format).c_str(), stdout);
  return {};
}

} // namespace

int main(int argc, char **argv) {
  CLI::App app{"Runs passes over the level IR of a format", "voxc-opt"};
  Options options;
  declare(app, options);
  return runTool(app, argc, argv, [&] { return optimise(options); });
}
