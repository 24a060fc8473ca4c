// voxc-trace: traces rays or takes a picture with a kernel that was compiled elsewhere.
#include "common/CameraOptions.h"
#include "common/Command.h"
#include "common/Files.h"
#include "common/Png.h"
#include "common/Statistics.h"
#include "common/Terminal.h"

#include "voxc/Trace/Picture.h"
#include "voxc/Trace/Tracer.h"

namespace {

using namespace voxc;
using namespace voxc::tool;

struct Options {
  CommonOptions common;
  CameraOptions camera;
  std::string volume;
  std::string kernel;
  std::string rays;
  std::string output;
  std::string device;
  unsigned repeat = 1;
  bool heatmap = false;
  bool count = false;
  bool trusted = false;
};

void addOptions(CLI::App &app, Options &options) {
  app.add_option("volume", options.volume, "Volume to trace")->required()->type_name("VOLUME.hvx");
  app.add_option("--kernel", options.kernel, "Its kernel, from voxc compile")
      ->required()
      ->type_name("KERNEL.spv");
  app.add_option(
         "--rays", options.rays,
         "Rays to trace: float32 origin and direction, 24 bytes each; without them a picture is taken")
      ->type_name("RAYS.bin");
  app.add_option("-o,--output", options.output,
                 "Hits to write: int32 x, y, z, uint32 rgba, float32 t, uint32 steps; or the picture")
      ->required()
      ->type_name("HITS.bin|PICTURE.png");
  addCameraOptions(app, options.camera);
  app.add_flag("--heatmap", options.heatmap, "Show the lookups that each ray took, with a legend");
  app.add_flag("--count", options.count, "Count each ray's lookups");
  app.add_option("--repeat", options.repeat, "Trace so often; the speeds are those of the fastest time")
      ->check(CLI::Range(1u, 1000000u));
  app.add_option("--device", options.device, "Trace on the device whose name contains this")
      ->type_name("NAME");
  app.add_flag("--trusted", options.trusted, "Skip the check of every offset in the volume");
  addCommonOptions(app, options.common);
}

Expected<void> checkUsage(const Options &options) {
  const CameraOptions &camera = options.camera;
  bool pictureOptions = options.heatmap || !camera.camera.empty() || !camera.size.empty() || camera.fov != 0;
  if (!options.rays.empty() && pictureOptions)
    return Error::usage("--rays writes hits: --camera, --size, --fov and --heatmap are for pictures");
  if (options.output == "-" && options.common.stats == "-")
    return Error::usage("-o and --stats cannot both write to standard output");
  return {};
}

/// The rays to trace, and the size of the picture that they make; 0 if they come from a file.
struct Job {
  std::vector<Ray> rays;
  int width = 0;
  int height = 0;
};

Expected<Job> makeJob(const Options &options, Int3 extent) {
  if (!options.rays.empty()) {
    auto rays = readRays(options.rays);
    if (!rays)
      return rays.error();
    return Job{std::move(*rays)};
  }
  auto camera = makeCamera(options.camera, extent);
  if (!camera)
    return camera.error();
  return Job{cameraRays(*camera), camera->width, camera->height};
}

Expected<void> writeResult(const Options &options, const Job &job, const Volume &volume,
                           std::span<Hit> hits) {
  if (!options.rays.empty())
    return writeHits(options.output, hits);
  if (volume.layout().payload == Payload::Material && !options.heatmap)
    showLabels(hits);
  Picture picture =
      options.heatmap ? heatmap(hits, job.width, job.height) : shade(job.rays, hits, job.width, job.height);
  return writePng(options.output, picture);
}

Expected<TraceReport> traceJob(const Options &options, Device &device, const Kernel &kernel,
                               const Volume &volume, const Job &job, std::vector<Hit> &hits, Json &figures) {
  Stopwatch upload;
  auto tracer = createTracer(device, kernel, volume);
  if (!tracer)
    return tracer.error();
  figures["upload_seconds"] = upload.seconds();
  ProgressBar bar(options.common.quiet);
  hits.resize(job.rays.size());
  return (*tracer)->trace(
      job.rays, hits,
      {.countSteps = options.count || options.heatmap, .repeat = options.repeat, .progress = bar.progress()});
}

/// The times of every repeat, for who wants more than the fastest.
void addRounds(Json &figures, const TraceReport &report) {
  Json seconds = Json::array(), cpuSeconds = Json::array(), deviceSeconds = Json::array();
  for (const TraceTime &time : report.repeats) {
    seconds.push_back(time.wall);
    cpuSeconds.push_back(time.cpu);
    if (time.device > 0)
      deviceSeconds.push_back(time.device);
  }
  figures["rounds"] = {{"seconds", seconds}, {"cpu_seconds", cpuSeconds}, {"device_seconds", deviceSeconds}};
}

Expected<void> run(const Options &options) {
  if (auto usage = checkUsage(options); !usage)
    return usage;
  Stopwatch loading;
  auto volume = Volume::load(options.volume, {.trusted = options.trusted});
  if (!volume)
    return volume.error();
  auto kernel = Kernel::load(options.kernel);
  if (!kernel)
    return kernel.error();
  Json figures;
  addVolumeFigures(figures, *volume);
  figures["load_seconds"] = loading.seconds();
  auto job = makeJob(options, volume->info().extent);
  if (!job)
    return job.error();
  auto device = Device::open(options.device);
  if (!device)
    return device.error();
  std::vector<Hit> hits;
  auto report = traceJob(options, *device, *kernel, *volume, *job, hits, figures);
  if (!report)
    return report.error();
  addTraceFigures(figures, *report, hits, device->info().name, options.count || options.heatmap);
  figures["driver"] = device->info().driver;
  figures["device_kind"] = device->info().kind;
  addRounds(figures, *report);
  if (auto written = writeResult(options, *job, *volume, hits); !written)
    return written;
  return writeStatistics(options.common.stats, std::move(figures));
}

} // namespace

int main(int argc, char **argv) {
  CLI::App app("Traces rays through a volume, or takes a picture of it, with a compiled kernel.",
               "voxc-trace");
  Options options;
  addOptions(app, options);
  return runTool(app, argc, argv, [&options] { return run(options); });
}
