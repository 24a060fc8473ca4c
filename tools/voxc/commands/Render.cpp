// voxc render: a picture of a volume.
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "options/Figures.h"
#include "options/Stages.h"
#include "options/VolumeArgument.h"
#include "pictures/RenderSession.h"
#include "program/Subcommand.h"
#include "tracing/DeviceMemory.h"

namespace voxc::tool {

namespace {

class RenderCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    volume_.declare(command);
    rendering_.declare(command);
    tracing_.declare(command);
    memory_.declare(command);
    command.option("--device-memory").excludes(command.option("--check"));
    memory_.declareCoarse(command);
    volume_.declareKernelOptions(command);
    addCommonOptions(command, common_);
  }

  Expected<void> run() override {
    rendering_.allowCoarse(memory_.allowedCoarse());
    VOXC_TRY(rendering_.check(volume_.path(), common_));
    Json figures;
    ProgressBar bar(common_.quiet);
    VOXC_TRY(render(bar, figures));
    bar.clear();
    addStages(figures, watch_.seconds());
    return tellFigures(common_, figures);
  }

private:
  Expected<void> render(ProgressBar &bar, Json &figures) {
    const Stopwatch watch;
    const auto frame = VOXC_TRY(volume_.frame());
    auto volume = VOXC_TRY(memory_.isGiven() ? memory_.open(volume_.path(), frame, figures) : volume_.load());
    if (!memory_.isGiven())
      addVolumeFigures(figures, volume);
    figures["load_seconds"] = watch.seconds();
    auto format = VOXC_TRY(volume_.kernelFormat(volume));
    VOXC_TRY(rendering_.applyTo(format));
    tracing_.useCache();
    const Stopwatch opening;
    VOXC_TRY(tracing_.openDevice(common_));
    figures["open_seconds"] = opening.seconds();
    if (memory_.isGiven())
      return renderPages(volume, format, bar, figures);
    VOXC_TRY(tracing_.prepare(volume, format, figures));
    SurfaceNormals normals(volume, tracing_.threads());
    return rendering_.render(volume, normals, tracing_, common_, bar, figures);
  }

  // What rays and normals read lies on a shelf, so that each finds what the other has read.
  Expected<void> renderPages(const Volume &outline, const Format &format, ProgressBar &bar, Json &figures) {
    const auto shelf = memory_.makeShelf();
    PagingOptions options;
    if (rendering_.looksAround(outline.info()))
      options.takesFrom = options.putsOn = shelf;
    VOXC_TRY(memory_.prepare(tracing_, format, figures, std::move(options)));
    SurfaceNormals normals = memory_.makeNormals(shelf, tracing_.threads());
    Expected<void> rendered = rendering_.render(outline, normals, tracing_, common_, bar, figures);
    figures["normal_pages_read"] = normals.pagesRead();
    return rendered;
  }

  Stopwatch watch_; ///< Of all.
  VolumeArgument volume_;
  RenderSession rendering_;
  DeviceMemory memory_; // Outlives the tracer.
  TraceSession tracing_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeRenderCommand() { return std::make_unique<RenderCommand>(); }

} // namespace voxc::tool
