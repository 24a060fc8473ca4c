// voxc run: compiles, builds and renders in one go.
#include "building/BuildSession.h"
#include "common/Terminal.h"
#include "frontend/AttributeOptions.h"
#include "options/Figures.h"
#include "options/InputArguments.h"
#include "options/Outputs.h"
#include "options/Stages.h"
#include "pictures/RenderSession.h"
#include "program/Subcommand.h"

namespace voxc::tool {

namespace {

class RunCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    building_.declare(command);
    building_.defaultInput(command, "builtin:terrain");
    rendering_.declare(command);
    addVolumePath(command, volumePath_, building_.inputArguments(), "Keeps the volume too").takes("V.hvx");
    building_.declareCompress(command);
    tracing_.declare(command);
    attributes_.declare(command);
    addCommonOptions(command, common_);
  }

  Expected<void> run() override {
    VOXC_TRY(rendering_.check(building_.input(), common_));
    if (!volumePath_.empty())
      VOXC_TRY(checkOutputFile(volumePath_));
    else if (building_.means().compress)
      return Error::usage("--compress is for the volume that is kept; name it by --volume V.hvx");
    Json figures;
    ProgressBar bar(common_.quiet);
    VOXC_TRY(buildAndRender(bar, figures));
    bar.clear();
    addStages(figures, watch_.seconds());
    return tellFigures(common_, figures);
  }

private:
  Expected<void> buildAndRender(ProgressBar &bar, Json &figures) {
    tracing_.useCache();
    const Stopwatch opening;
    VOXC_TRY(tracing_.openDevice(common_));
    figures["open_seconds"] = opening.seconds();
    auto format =
        VOXC_TRY(building_.readFormat(tracing_.deviceInfo().name, common_, bar.progress(), figures));
    VOXC_TRY(attributes_.apply(format));
    VOXC_TRY(rendering_.applyTo(format));
    building_.useThreads(tracing_.threads());
    auto volume = VOXC_TRY(building_.build(format, volumePath_, common_, bar.progress(), figures));
    VOXC_TRY(tracing_.prepare(volume, format, figures));
    SurfaceNormals normals(volume, tracing_.threads());
    return rendering_.render(volume, normals, tracing_, common_, bar, figures);
  }

  Stopwatch watch_; ///< Of all.
  BuildSession building_;
  AttributeOptions attributes_;
  RenderSession rendering_;
  TraceSession tracing_;
  std::string volumePath_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeRunCommand() { return std::make_unique<RunCommand>(); }

} // namespace voxc::tool
