// voxc-opt: runs passes over IR text and prints the IR that comes out.
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
  bool helpPasses = false;
  bool helpLevels = false;
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
  app.add_flag("--help-passes", options.helpPasses, "Describe the passes and exit");
  app.add_flag("--help-levels", options.helpLevels, "Describe the level kinds and exit");
  options.passes.declare(app, PassChoice::All);
}

void describePasses() {
  for (const Pass &pass : passes())
    std::printf("--%s (%s)\n  %s\n\n%s\n\n", std::string(pass.name).c_str(),
                pass.effect == AttributeEffect::Storage ? "storage" : "walk",
                std::string(pass.summary).c_str(), std::string(pass.details).c_str());
}

void describeAttributes(AttributeKinds attributes) {
  for (const AttributeKind *attribute : attributes) {
    std::printf("  %s (%s):", std::string(attribute->name).c_str(),
                attribute->effect == AttributeEffect::Storage ? "storage" : "walk");
    for (const std::string_view value : attribute->values)
      std::printf(" %s", std::string(value).c_str());
    std::printf("; %s\n", std::string(attribute->summary).c_str());
  }
  std::printf("\n");
}

void describeLevel(const LevelKind &kind) {
  std::string parameters;
  for (const ParameterKind &parameter : kind.parameters)
    parameters += (parameters.empty() ? "" : ", ") + std::string(parameter.name);
  std::printf("%c(%s), in IR %s(%s)\n  %s\n\n", kind.letter, parameters.c_str(),
              std::string(kind.name).c_str(), parameters.c_str(), std::string(kind.summary).c_str());
  for (const ParameterKind &parameter : kind.parameters)
    std::printf("  %s: %s\n", std::string(parameter.name).c_str(), std::string(parameter.meaning).c_str());
  describeAttributes(kind.attributes);
}

void describeLevels() {
  for (const LevelKind *kind : levelKinds())
    describeLevel(*kind);
  std::printf("A format as a whole, in IR after the word format\n\n");
  describeAttributes(formatAttributes());
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
  if (options.helpPasses) {
    describePasses();
    return {};
  }
  if (options.helpLevels) {
    describeLevels();
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
