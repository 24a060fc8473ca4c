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
    if (Expected<void> merged = tasks_->run(arguments_, bar.progress(), figures); !merged)
      return merged;
    bar.clear();
    return tellFigures(common_, figures);
  }

  Expected<void> runWhole() {
    if (Expected<void> writable = checkOutputFile(output_); !writable)
      return writable;
    Json figures;
    ProgressBar bar(common_.quiet);
    if (Expected<void> merged = merge(bar.progress(), figures); !merged)
      return merged;
    bar.clear();
    return tellFigures(common_, figures);
  }

  Expected<void> merge(const Progress &progress, Json &figures) {
    Expected<Format> format = formatOfFragment(fragments_.front());
    if (!format)
      return format.error();
    Expected<Constructor> constructor = Constructor::compile(*format, compileCache());
    if (!constructor)
      return constructor.error();
    const BuildOptions options{.threads = threadsOf(arguments_),
                               .memory = makeWorkingMemory(arguments_),
                               .path = output_,
                               .progress = progress,
                               .compress = arguments_.compress};
    Expected<Built> built = constructor->merge(fragments_, options);
    if (!built)
      return built.error();
    figures["fragments"] = fragments_.size();
    addVolumeFigures(figures, built->volume);
    addBuildFigures(figures, built->report);
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
