// voxc trace: the hits of the rays of a file.
#include "DeviceMemory.h"
#include "ErrorCheck.h"
#include "Figures.h"
#include "Outputs.h"
#include "Subcommand.h"
#include "Tracing.h"
#include "VolumeArgument.h"

#include "common/Files.h"
#include "common/Statistics.h"
#include "common/Terminal.h"

#include <CLI/CLI.hpp>

#include <vector>

namespace voxc::tool {

namespace {

class TraceCommand final : public Subcommand {
public:
  void declare(CLI::App &app) override {
    volume_.declare(app);
    app.add_option("--rays", rays_,
                   "Rays to trace: float32 origin and direction, 24 bytes each; - for standard input")
        ->type_name("R.bin")
        ->required();
    app.add_option("-o,--output", output_,
                   "Hits to write: int32 x, y, z, uint32 rgba, float32 t, uint32 steps, 24 bytes each; - for "
                   "standard "
                   "output")
        ->type_name("H.bin")
        ->required();
    app.add_option("--repeat", options_.repeat, "Trace so often; the speeds are those of the fastest time")
        ->type_name("N")
        ->check(CLI::Range(1u, 1000000u).description(""))
        ->capture_default_str();
    app.add_option(
           "--lod-spread", options_.spread,
           "Stop at nodes and cells narrower than this times their distance, with a colour from inside")
        ->type_name("S")
        ->check(CLI::Range(0.0f, 1e6f).description(""));
    app.add_flag("--count", options_.countSteps, "Count each ray's lookups");
    check_.declare(app);
    tracing_.declare(app);
    memory_.declare(app);
    volume_.declareKernelOptions(app);
    addCommonOptions(app, common_);
  }

  Expected<void> run() override {
    if (Expected<void> writable = checkOutput(output_, common_); !writable)
      return writable;
    Json figures;
    ProgressBar bar(common_.quiet);
    options_.progress = bar.progress();
    if (Expected<void> traced = trace(figures); !traced)
      return traced;
    bar.clear();
    return tellFigures(common_, figures);
  }

private:
  /// What the hits say; where lookups are counted they stand in place of faces.
  Question questionOfHits(const Format &format) const {
    Question question = questionOf(format);
    question.outputs.face = question.outputs.face && !options_.countSteps;
    return question;
  }

  Expected<void> trace(Json &figures) {
    const Stopwatch watch;
    Expected<Volume> volume = memory_.isGiven() ? memory_.open(volume_.path(), figures) : volume_.load();
    if (!volume)
      return volume.error();
    if (!memory_.isGiven())
      addVolumeFigures(figures, *volume);
    figures["load_seconds"] = watch.seconds();
    Expected<Format> format = volume_.kernelFormat(*volume);
    if (!format)
      return format.error();
    if (options_.spread > 0)
      format->setAttribute(kDetailAttribute, "cone");
    Expected<std::vector<Ray>> rays = readRays(rays_);
    if (!rays)
      return rays.error();
    tracing_.useCache();
    if (Expected<void> opened = tracing_.openDevice(common_); !opened)
      return opened;
    if (Expected<void> prepared = memory_.isGiven() ? memory_.prepare(tracing_, *format, figures)
                                                    : tracing_.prepare(*volume, *format, figures);
        !prepared)
      return prepared;

    std::vector<Hit> hits(rays->size());
    if (Expected<void> traced = tracing_.trace(*rays, hits, options_, figures); !traced)
      return traced;
    if (!memory_.isGiven())
      if (Expected<void> checked =
              check_.run(*volume, *rays, hits, questionOfHits(*format), options_.progress, figures);
          !checked)
        return checked;
    addWritten(figures, output_);
    return writeHits(output_, hits);
  }

  VolumeArgument volume_;
  std::string rays_;
  std::string output_;
  TraceOptions options_;
  ErrorCheck check_{1000};
  DeviceMemory memory_; // Outlives the tracer.
  Tracing tracing_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeTraceCommand() { return std::make_unique<TraceCommand>(); }

} // namespace voxc::tool
