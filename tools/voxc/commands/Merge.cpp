// voxc merge: joins the fragments of a volume.
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "options/BuildFigures.h"
#include "options/Figures.h"
#include "options/Outputs.h"
#include "program/Applications.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Support/UserCache.h"

namespace voxc::tool {

namespace {

class MergeCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    command.add("FRAGMENT", fragments_, "All fragments of one volume, in any order").required().takes("");
    command.add("-o,--output", output_, "Volume to write").takes("V.hvx").required();
    addMemoryArguments(command, arguments_);
    addCompressArgument(command, arguments_.compress);
    addCommonOptions(command, common_);
    if (tasks_)
      tasks_->declare(command);
  }

  Expected<void> run() override { return tasks_ && tasks_->isGiven() ? runTasks() : runWhole(); }

private:
  Expected<void> runTasks() {
    Json figures;
    ProgressBar bar(common_.quiet);
    VOXC_TRY(tasks_->run(arguments_, bar.progress(), figures));
    bar.clear();
    return tellFigures(common_, figures);
  }

  Expected<void> runWhole() {
    VOXC_TRY(checkOutputFile(output_));
    Json figures;
    ProgressBar bar(common_.quiet);
    VOXC_TRY(merge(bar.progress(), figures));
    bar.clear();
    return tellFigures(common_, figures);
  }

  Expected<void> merge(const Progress &progress, Json &figures) {
    auto format = VOXC_TRY(formatOfFragment(fragments_.front()));
    auto constructor = VOXC_TRY(Constructor::compile(format, compileCache()));
    const BuildOptions options{.threads = threadsOf(arguments_),
                               .memory = makeWorkingMemory(arguments_),
                               .path = output_,
                               .progress = progress,
                               .compress = arguments_.compress};
    auto built = VOXC_TRY(constructor.merge(fragments_, options));
    figures["fragments"] = fragments_.size();
    addVolumeFigures(figures, built.volume);
    addBuildFigures(figures, built.report);
    addFileFigure(figures, output_);
    addWritten(figures, output_);
    return {};
  }

  std::vector<std::string> fragments_;
  std::string output_;
  std::unique_ptr<TaskOption> tasks_ = makeMergeTasks();
  BuildArguments arguments_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeMergeCommand() { return std::make_unique<MergeCommand>(); }

} // namespace voxc::tool
