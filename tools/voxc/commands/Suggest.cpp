// voxc suggest: the format that an input asks for, found without building any.
#include "choosing/ObjectiveOption.h"
#include "choosing/SuggestReport.h"
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "options/BuildArguments.h"
#include "options/Figures.h"
#include "program/Subcommand.h"
#include "voxc/Measure/SavedWeights.h"

#include <cstdio>

namespace voxc::tool {

namespace {

class SuggestCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    command.add("INPUT", request_.input, kInputHelp).required().takes("");
    addInputArguments(command, request_.arguments);
    command.option("--resolution")
        .text("Voxels on the longest axis; default: " + std::to_string(kDefaultResolution));
    addObjectiveArgument(command, objective_, "What is wanted");
    addMaxBytesArgument(command, buildArguments_);
    command.option("--max-bytes").text("The most bytes that the volume's words may take, such as 64MiB");
    command
        .add("--device", request_.device,
             "Device that will trace: cpu (default), or one of Vulkan's that is a processor")
        .takes("NAME");
    command
        .add("--rays", request_.rayFiles,
             "A file of rays in place of sampled ones; may be given several times")
        .takes("R.bin");
    command
        .add("--formats", request_.formatList,
             "Choose from these in place of those that voxc knows: \"F;F;F\", or a file with one a line, a "
             "label and a tab before it if you like")
        .takes("LIST");
    command.addFlag("--editable", request_.editable, "Only formats whose volumes can be edited in place");
    command.addFlag("--all", all_, "List all formats that no other beats in both size and speed");
    addMemoryArguments(command, buildArguments_);
    addCommonOptions(command, common_);
  }

  Expected<void> run() override {
    VOXC_TRY(measure::checkSpeedsKnown(request_.device));
    ProgressBar bar(common_.quiet);
    request_.wish = {objectiveOf(objective_),
                     std::min(maxWordsOf(buildArguments_), kMaxWords) * sizeof(std::uint32_t)};
    request_.memory = makeWorkingMemory(buildArguments_);
    Json figures;
    auto suggestion = VOXC_TRY(makeSuggestion(request_, common_, bar.progress(), figures));
    bar.clear();
    if (tellsOnStdout(common_))
      std::fputs(suggestReport(suggestion, all_).c_str(), stdout);
    addSuggestFigures(figures, suggestion);
    return writeStatistics(common_.stats, figures);
  }

private:
  SuggestRequest request_;
  std::string objective_ = "balanced";
  bool all_ = false;
  BuildArguments buildArguments_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeSuggestCommand() { return std::make_unique<SuggestCommand>(); }

} // namespace voxc::tool
