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
    if (Expected<void> checked = rendering_.check(building_.input(), common_); !checked)
      return checked;
    if (!volumePath_.empty())
      if (Expected<void> writable = checkOutputFile(volumePath_); !writable)
        return writable;
    Json figures;
    ProgressBar bar(common_.quiet);
    if (Expected<void> rendered = buildAndRender(bar, figures); !rendered)
      return rendered;
    bar.clear();
    addStages(figures, watch_.seconds());
    return tellFigures(common_, figures);
  }

private:
  Expected<void> buildAndRender(ProgressBar &bar, Json &figures) {
    tracing_.useCache();
    const Stopwatch opening;
    if (Expected<void> opened = tracing_.openDevice(common_); !opened)
      return opened;
    figures["open_seconds"] = opening.seconds();
    Expected<Format> format =
        building_.readFormat(tracing_.deviceInfo().name, common_, bar.progress(), figures);
    if (!format)
      return format.error();
    if (Expected<void> applied = attributes_.apply(*format); !applied)
      return applied;
    if (Expected<void> applied = rendering_.applyTo(*format); !applied)
      return applied;
    building_.useThreads(tracing_.threads());
    Expected<Volume> volume = building_.build(*format, volumePath_, common_, bar.progress(), figures);
    if (!volume)
      return volume.error();
    if (Expected<void> prepared = tracing_.prepare(*volume, *format, figures); !prepared)
      return prepared;
    SurfaceNormals normals(*volume, tracing_.threads());
    return rendering_.render(*volume, normals, tracing_, common_, bar, figures);
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
