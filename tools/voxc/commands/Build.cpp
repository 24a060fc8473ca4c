// voxc build: voxelizes an input and writes its volume.
#include "building/BuildSession.h"
#include "building/FragmentOption.h"
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "options/Figures.h"
#include "options/Outputs.h"
#include "program/Applications.h"

namespace voxc::tool {

namespace {

class BuildCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    building_.declare(command);
    building_.declareThreads(command);
    building_.declareMaxBytes(command);
    building_.declareCompress(command);
    building_.declareFrames(command);
    fragment_.declare(command, "Build one of N fragments only, for voxc merge");
    command.add("-o,--output", output_, "Volume to write, or fragment").takes("FILE").required();
    addCommonOptions(command, common_);
    if (tasks_)
      tasks_->declare(command);
  }

  Expected<void> run() override { return tasks_ && tasks_->isGiven() ? runTasks() : runWhole(); }

private:
  Expected<void> runTasks() {
    Json figures;
    ProgressBar bar(common_.quiet);
    VOXC_TRY(tasks_->run(building_.means(), bar.progress(), figures));
    bar.clear();
    return tellFigures(common_, figures);
  }

  Expected<void> runWhole() {
    VOXC_TRY(checkOutputFile(output_));
    Json figures;
    ProgressBar bar(common_.quiet);
    auto format = VOXC_TRY(building_.readFormat("cpu", common_, bar.progress(), figures));
    if (Expected<void> built = build(format, bar.progress(), figures); !built) {
      // How far it came; that this cannot be written as well is no news.
      figures["failed"] = built.error().message;
      static_cast<void>(writeStatistics(common_.stats, figures));
      return built;
    }
    bar.clear();
    return tellFigures(common_, figures);
  }

  Expected<void> build(Format &format, const Progress &progress, Json &figures) {
    if (building_.takesFrames() && fragment_.choice())
      return Error::usage("fragments are of one frame; leave --frames or --fragment out");
    if (const auto fragment = fragment_.choice())
      return building_.buildFragment(format, fragment->index, fragment->count, output_, common_, progress,
                                     figures);
    Expected<Volume> volume = building_.build(format, output_, common_, progress, figures);
    return volume ? Expected<void>() : volume.error();
  }

  BuildSession building_;
  FragmentOption fragment_;
  std::unique_ptr<TaskOption> tasks_ = makeBuildTasks();
  std::string output_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeBuildCommand() { return std::make_unique<BuildCommand>(); }

} // namespace voxc::tool
