// voxc trace: the hits of the rays of a file.
#include "common/Files.h"
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "options/Figures.h"
#include "options/Outputs.h"
#include "options/VolumeArgument.h"
#include "program/Subcommand.h"
#include "tracing/DeviceMemory.h"
#include "tracing/ErrorCheck.h"
#include "tracing/TraceSession.h"
#include "voxc/IR/Query.h"

#include <optional>
#include <vector>

namespace voxc::tool {

namespace {

class TraceCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    volume_.declare(command);
    command
        .add("--rays", rays_,
             "Rays to trace: float32 origin and direction, 24 bytes each, or a file of version 2, with "
             "bounds; - for standard input")
        .takes("R.bin")
        .required();
    command
        .add("-o,--output", output_,
             "Hits to write: int32 x, y, z, uint32 rgba, float32 t, uint32 steps, 24 bytes each, or a file "
             "of version 2; - for standard output")
        .takes("H.bin")
        .required();
    command.add("--tmin", tmin_, "Look for voxels that rays enter at this t or later").takes("T");
    command.add("--tmax", tmax_, "Look for voxels that rays enter at this t or before").takes("T");
    command
        .add("--hit-version", hitVersion_,
             "Version of the hit file: 2 has the face and its normal too; default: that of the ray file, or "
             "1 where the query is not of the closest hit")
        .takes("1|2")
        .between(1u, 2u);
    command.add("--repeat", options_.repeat, "Trace so often; the speeds are those of the fastest time")
        .takes("N")
        .between(1u, 1000000u)
        .showsDefault();
    command
        .add("--lod-spread", options_.spread,
             "Stop at nodes and cells narrower than this times their distance, with a colour from inside")
        .takes("S")
        .between(0.0f, 1e6f);
    command.addFlag("--count", options_.countSteps, "Count each ray's lookups");
    check_.declare(command);
    tracing_.declare(command);
    memory_.declare(command);
    command.option("--device-memory").excludes(command.option("--check"));
    volume_.declareKernelOptions(command);
    addCommonOptions(command, common_);
  }

  Expected<void> run() override {
    VOXC_TRY(checkOutput(output_, common_));
    Json figures;
    ProgressBar bar(common_.quiet);
    options_.progress = bar.progress();
    VOXC_TRY(trace(figures));
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

  /// The rays, with the bounds of their file or of the options.
  Expected<RayFile> readBoundedRays() const {
    Expected<RayFile> file = readRayFile(rays_);
    if (!file || (!tmin_ && !tmax_))
      return file;
    if (file->rays().isBounded())
      return Error::usage("--tmin and --tmax are for rays without bounds, but " + rays_ +
                          " has rays with bounds");
    const RayBounds defaults;
    std::vector<BoundedRay> rays;
    rays.reserve(file->rays().size());
    for (const Ray &ray : std::move(*file).takeRays())
      rays.push_back(bounded(ray, {tmin_.value_or(defaults.tmin), tmax_.value_or(defaults.tmax)}));
    return RayFile(std::move(rays));
  }

  /// Asks the kernel for what rays and hits have.
  Expected<void> ask(Format &format, int rayVersion, bool bounds) {
    if (options_.spread > 0)
      askForCones(format);
    if (bounds)
      askForBounds(format);
    const bool isClosest = isOfHits(questionOf(format).query);
    if (hitVersion_ == 2 && !isClosest)
      return Error::usage("hits of version 2 have faces, which --query closest alone reports");
    if (hitVersion_ == 0)
      hitVersion_ = isClosest ? rayVersion : 1;
    if (hitVersion_ == 2)
      format.setAttribute(kFaceAttribute, "yes");
    if (const std::string_view problem = problemOfQuestion(format); !problem.empty())
      return Error::usage("the format " + std::string(problem));
    return {};
  }

  /// Writes the hits; where those of version 2 have lookups in place of faces, rays are traced for faces too.
  Expected<void> writeAll(const RaySpan &rays, std::span<const Hit> hits) {
    if (hitVersion_ == 1)
      return writeHits(output_, hits);
    if (!options_.countSteps)
      return writeText(output_, hitFileText(hits));
    std::vector<std::uint32_t> steps;
    for (const Hit &hit : hits)
      steps.push_back(hit.steps);
    std::vector<Hit> faces(hits.size());
    VOXC_TRY(tracing_.trace(rays, faces, {.progress = options_.progress}));
    return writeText(output_, hitFileText(faces, steps));
  }

  Expected<void> trace(Json &figures) {
    const Stopwatch watch;
    const auto frame = VOXC_TRY(volume_.frame());
    auto volume = VOXC_TRY(memory_.isGiven() ? memory_.open(volume_.path(), frame, figures) : volume_.load());
    if (!memory_.isGiven())
      addVolumeFigures(figures, volume);
    figures["load_seconds"] = watch.seconds();
    auto format = VOXC_TRY(volume_.kernelFormat(volume));
    const auto file = VOXC_TRY(readBoundedRays());
    const RaySpan rays = file.rays();
    VOXC_TRY(ask(format, tmin_ || tmax_ ? 1 : file.version(), rays.isBounded()));
    tracing_.useCache();
    if (options_.repeat <= 1 && common_.stats.empty()) // Else times are what is asked for.
      tracing_.expectRays(rays.size());
    VOXC_TRY(tracing_.openDevice(common_));
    if (Expected<void> prepared = memory_.isGiven() ? memory_.prepare(tracing_, format, figures)
                                                    : tracing_.prepare(volume, format, figures);
        !prepared)
      return prepared;

    std::vector<Hit> hits(rays.size());
    VOXC_TRY(tracing_.trace(rays, hits, options_, figures));
    if (!memory_.isGiven())
      if (Expected<void> checked =
              check_.run(volume, rays, hits, questionOfHits(format), options_.progress, figures);
          !checked)
        return checked;
    addWritten(figures, output_);
    return writeAll(rays, hits);
  }

  VolumeArgument volume_;
  std::string rays_;
  std::string output_;
  std::optional<float> tmin_, tmax_;
  int hitVersion_ = 0; ///< 0: as the ray file says.
  TraceOptions options_;
  ErrorCheck check_{1000};
  DeviceMemory memory_; // Outlives the tracer.
  TraceSession tracing_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeTraceCommand() { return std::make_unique<TraceCommand>(); }

} // namespace voxc::tool
