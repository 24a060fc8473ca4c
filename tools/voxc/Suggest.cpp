// voxc suggest: the format that an input asks for, found without building any.
#include "BuildArguments.h"
#include "Subcommand.h"
#include "SuggestReport.h"

#include "common/Statistics.h"
#include "common/Terminal.h"
#include "search/ObjectiveOption.h"

#include <CLI/CLI.hpp>

#include <cstdio>

namespace voxc::tool {

namespace {

class SuggestCommand final : public Subcommand {
public:
  void declare(CLI::App &app) override {
    app.add_option("INPUT", request_.input, kInputHelp)->required()->type_name("");
    addInputArguments(app, request_.arguments);
    app.get_option("--resolution")
        ->description("Voxels on the longest axis; default: " + std::to_string(kDefaultResolution));
    addObjectiveArgument(app, objective_, "What is wanted");
    addMaxBytesArgument(app, buildArguments_);
    app.get_option("--max-bytes")
        ->description("The most bytes that the volume's words may take, such as 64MiB");
    app.add_option("--device", request_.device,
                   "Device that will trace: cpu (default), or one of Vulkan's that is a processor")
        ->type_name("NAME");
    app.add_option("--rays", request_.rayFiles,
                   "A file of rays in place of sampled ones; may be given several times")
        ->type_name("R.bin");
    app.add_option("--formats", request_.formatsPath,
                   "A file of formats, one a line, in place of those that voxc knows")
        ->type_name("FILE");
    app.add_flag("--all", all_, "List all formats that no other beats in both size and speed");
    addMemoryArguments(app, buildArguments_);
    addCommonOptions(app, common_);
  }

  Expected<void> run() override {
    ProgressBar bar(common_.quiet);
    request_.wish = {objectiveOf(objective_),
                     std::min(maxWordsOf(buildArguments_), kMaxWords) * sizeof(std::uint32_t)};
    request_.memory = makeWorkingMemory(buildArguments_);
    Json figures;
    Expected<Suggestion> suggestion = makeSuggestion(request_, common_, bar.progress(), figures);
    if (!suggestion)
      return suggestion.error();
    bar.clear();
    std::fputs(suggestReport(*suggestion, all_).c_str(), stdout);
    addSuggestFigures(figures, *suggestion);
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
