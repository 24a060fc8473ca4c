// voxc render: a picture of a volume.
#include "DeviceMemory.h"
#include "Figures.h"
#include "Rendering.h"
#include "Subcommand.h"
#include "VolumeArgument.h"

#include "common/Statistics.h"
#include "common/Terminal.h"

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
    if (Expected<void> checked = rendering_.check(volume_.path(), common_); !checked)
      return checked;
    rendering_.allowCoarse(memory_.allowedCoarse());
    Json figures;
    ProgressBar bar(common_.quiet);
    if (Expected<void> rendered = render(bar, figures); !rendered)
      return rendered;
    bar.clear();
    return tellFigures(common_, figures);
  }

private:
  Expected<void> render(ProgressBar &bar, Json &figures) {
    const Stopwatch watch;
    Expected<Volume> volume = memory_.isGiven() ? memory_.open(volume_.path(), figures) : volume_.load();
    if (volume && memory_.isGiven() && rendering_.looksAround(volume->info()))
      volume = volume_.load(); // For this processor, not for the device.
    if (!volume)
      return volume.error();
    if (!memory_.isGiven())
      addVolumeFigures(figures, *volume);
    figures["load_seconds"] = watch.seconds();
    Expected<Format> format = volume_.kernelFormat(*volume);
    if (!format)
      return format.error();
    if (Expected<void> applied = rendering_.applyTo(*format); !applied)
      return applied;
    tracing_.useCache();
    if (Expected<void> opened = tracing_.openDevice(common_); !opened)
      return opened;
    if (Expected<void> prepared = memory_.isGiven() ? memory_.prepare(tracing_, *format, figures)
                                                    : tracing_.prepare(*volume, *format, figures);
        !prepared)
      return prepared;
    return rendering_.render(*volume, tracing_, common_, bar, figures);
  }

  VolumeArgument volume_;
  Rendering rendering_;
  DeviceMemory memory_; // Outlives the tracer.
  Tracing tracing_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeRenderCommand() { return std::make_unique<RenderCommand>(); }

} // namespace voxc::tool
