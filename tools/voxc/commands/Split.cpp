// voxc split: cuts a finished volume into fragments, which voxc merge joins again.
#include "voxc/Construct/Split.h"
#include "building/FragmentOption.h"
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "options/BuildFigures.h"
#include "options/Figures.h"
#include "options/Outputs.h"
#include "options/VolumeArgument.h"
#include "program/Subcommand.h"

namespace voxc::tool {

namespace {

class SplitCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    volume_.declare(command);
    fragment_.declare(command, "Write one of N fragments only; all of the volume is fragment 0/1");
    command.add("-o,--output", output_, "Fragment to write").takes("F.hvf").required();
    addCommonOptions(command, common_);
  }

  Expected<void> run() override {
    VOXC_TRY(checkOutputFile(output_));
    auto volume = VOXC_TRY(volume_.load());
    if (const std::size_t frames = framesOf(volume).size(); frames > 0)
      return Error::usage("'" + volume_.path() + "' has " + std::to_string(frames) +
                          " frames, and fragments hold one; choose it by --frame N");
    VOXC_TRY(volume_.leaveOtherFrames(output_, common_));
    const auto summary = VOXC_TRY(summarizeVolume(volume_.path()));
    if (sideStreamsOf(summary).attributes && !common_.quiet)
      printNote("warning: fragments have no attributes; voxc attach gives new ones to what they merge to");
    const FragmentChoice fragment = fragment_.choice().value_or(FragmentChoice{});
    ProgressBar bar(common_.quiet);
    const auto report =
        VOXC_TRY(splitVolume(volume, fragment.index, fragment.count, output_, bar.progress()));
    bar.clear();
    Json figures;
    figures["voxels"] = report.voxels;
    figures["split_seconds"] = report.seconds;
    addFileFigure(figures, output_);
    addWritten(figures, output_);
    return tellFigures(common_, figures);
  }

private:
  VolumeArgument volume_;
  FragmentOption fragment_;
  std::string output_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeSplitCommand() { return std::make_unique<SplitCommand>(); }

} // namespace voxc::tool
