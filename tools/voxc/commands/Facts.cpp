// voxc facts: what an input is like, to choose a format by.
#include "choosing/FactsFigures.h"
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "options/BuildArguments.h"
#include "options/BuildFigures.h"
#include "options/Figures.h"
#include "options/InputArguments.h"
#include "program/Subcommand.h"

#include <cstdio>

namespace voxc::tool {

namespace {

class FactsCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    command.add("INPUT", input_, kInputHelp).required().takes("");
    addInputArguments(command, inputArguments_);
    command.option("--resolution")
        .text("Voxels on the longest axis; default: " + std::to_string(kDefaultResolution));
    addMemoryArguments(command, buildArguments_);
    command.option("--memory")
        .text("Bound on the memory, such as 512MiB; default: a quarter of the machine's");
    addCommonOptions(command, common_);
  }

  Expected<void> run() override {
    ProgressBar bar(common_.quiet);
    Json figures;
    auto facts = VOXC_TRY(measure(bar.progress(), figures));
    bar.clear();
    if (tellsOnStdout(common_))
      std::fputs(factsReport(facts).c_str(), stdout);
    return writeStatistics(common_.stats, figures);
  }

private:
  Expected<Facts> measure(const Progress &progress, Json &figures) const {
    VOXC_TRY(checkInputArguments(inputArguments_, input_));
    InputArguments arguments = inputArguments_;
    fillResolution(arguments, input_);
    constexpr int kMost = 1 << kMaxLog2Extent;
    InputOptions options = makeInputOptions(arguments, {kMost, kMost, kMost});
    options.memory = makeWorkingMemory(buildArguments_);
    options.progress = progress;
    auto input = VOXC_TRY(openInput(input_, options));
    ToldSentences told;
    tellWarnings(input, common_, told);
    const Stopwatch watch;
    auto facts = VOXC_TRY(measureFacts(*input.source, {.memory = options.memory}, progress));
    figures = factsFigures(facts);
    addInputFigures(figures, input);
    figures["voxelize_seconds"] = input.source->readSeconds();
    figures["facts_seconds"] = watch.seconds();
    figures["facts_cpu_seconds"] = watch.cpuSeconds();
    figures["memory_bound_bytes"] = options.memory->bound();
    figures["scratch_bytes"] = options.memory->scratchPeak();
    return facts;
  }

  std::string input_;
  InputArguments inputArguments_;
  BuildArguments buildArguments_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeFactsCommand() { return std::make_unique<FactsCommand>(); }

} // namespace voxc::tool
