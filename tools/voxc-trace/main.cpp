// voxc-trace: traces rays or takes a picture with a kernel that was compiled elsewhere.
#include "common/Command.h"
#include "common/CommandLine.h"
#include "common/Files.h"
#include "common/ManualPage.h"
#include "common/OrderOption.h"
#include "common/PictureFile.h"
#include "common/PictureOptions.h"
#include "common/RayTally.h"
#include "common/Statistics.h"
#include "common/Terminal.h"

#include "voxc/Trace/Tracer.h"

namespace {

using namespace voxc;
using namespace voxc::tool;

struct Options {
  CommonOptions common;
  PictureOptions picture;
  std::string volume;
  std::string kernel;
  std::string rays;
  std::string output;
  std::string device;
  std::string order = kAutoOrder;
  unsigned repeat = 1;
  bool count = false;
  bool trusted = false;
};

void addOptions(const CommandLine &command, Options &options) {
  command.add("volume", options.volume, "Volume to trace").required().takes("VOLUME.hvx");
  command.add("--kernel", options.kernel, "Its kernel, from voxc compile").required().takes("KERNEL.spv");
  command
      .add("--rays", options.rays,
           "Rays to trace: float32 origin and direction, 24 bytes each, or a file of version 2, with bounds, "
           "for a kernel for such; without them a picture is taken")
      .takes("RAYS.bin");
  command
      .add("-o,--output", options.output,
           "Hits to write: int32 x, y, z, uint32 rgba, float32 t, uint32 steps; or the picture, as " +
               pictureEndings())
      .required()
      .takes("HITS.bin|PICTURE");
  addPictureOptions(command, options.picture);
  command.addFlag("--count", options.count, "Count each ray's lookups; of a picture as with --repeat");
  command
      .add("--repeat", options.repeat,
           "Trace so often; the speeds are those of the fastest time; a picture is flat then, unless --style "
           "says")
      .between(1u, 1000000u);
  command
      .add("--device", options.device,
           "Trace on the device whose name contains this, or with this number or UUID")
      .takes("NAME");
  addOrderArgument(command, options.order);
  command.addFlag("--trusted", options.trusted, "Skip the check of every offset in the volume");
  addManual(command);
  addCommonOptions(command, options.common);
}

Expected<void> checkUsage(const CommandLine &command, const Options &options) {
  if (options.output == "-" && options.common.stats == "-")
    return Error::usage("-o and --stats cannot both write to standard output");
  if (options.rays.empty()) {
    Expected<void> named = checkPictureName(options.output);
    return named ? checkPictureOptions(options.picture) : named;
  }
  const CommandLine forPictures;
  PictureOptions unused;
  addPictureOptions(forPictures, unused);
  for (const Option &option : forPictures.options())
    if (const std::optional<Option> given = command.find(option.name());
        given && given->count() > 0 && option.name() != "--help")
      return Error::usage("--rays writes hits: " + option.name() + " is for pictures");
  return {};
}

/// Traces rays in that order, and counts them in `tally`.
auto tracingInto(RayTally &tally, Tracer &tracer, RayOrder order) {
  return [&tally, &tracer, order](const RaySpan &rays, std::span<Hit> hits,
                                  const TraceOptions &options) -> Expected<void> {
    TraceOptions how = options;
    how.order = order;
    const auto report = VOXC_TRY(tracer.trace(rays, hits, how));
    tally.add(rays, hits, report, options.countSteps);
    return {};
  };
}

/// Traces the rays of a file, and writes their hits.
Expected<void> traceRays(const Options &options, Tracer &tracer, RayTally &tally, const Progress &progress) {
  const auto file = VOXC_TRY(readRayFile(options.rays));
  std::vector<Hit> hits(file.rays().size());
  const TraceOptions how{.countSteps = options.count, .repeat = options.repeat, .progress = progress};
  VOXC_TRY(tracingInto(tally, tracer, rayOrderFrom(options.order))(file.rays(), hits, how));
  return writeHits(options.output, hits);
}

/// Takes the picture, and writes it.
Expected<void> takePicture(const Options &options, const Volume &volume, Tracer &tracer, RayTally &tally,
                           ProgressBar &bar, Json &figures) {
  RayTally others;
  const RayOrder order = rayOrderFrom(options.order);
  const auto other = tracingInto(others, tracer, order);
  const auto camera = [&](std::span<const Ray> rays, std::span<Hit> hits, TraceOptions how) {
    how.repeat = options.repeat;
    how.countSteps |= options.count;
    return tracingInto(tally, tracer, order)(rays, hits, how);
  };
  const auto taken =
      VOXC_TRY(tool::takePicture(options.picture, volume, {camera, other}, other, 0, bar.progress()));
  bar.clear();
  if (const auto warning = cameraWarning(taken, volume); warning && !options.common.quiet)
    printNote("warning: " + *warning);
  addCameraFigures(figures, options.picture, taken.placed, volume);
  return writeTaken(options.output, taken);
}

/// The times of every repeat, for who wants more than the fastest.
void addRounds(Json &figures, const std::vector<TraceTime> &times) {
  Json seconds = Json::array(), cpuSeconds = Json::array(), deviceSeconds = Json::array();
  for (const TraceTime &time : times) {
    seconds.push_back(time.wall);
    cpuSeconds.push_back(time.cpu);
    if (time.device > 0)
      deviceSeconds.push_back(time.device);
  }
  figures["rounds"] = {{"seconds", seconds}, {"cpu_seconds", cpuSeconds}, {"device_seconds", deviceSeconds}};
}

Expected<void> run(const CommandLine &command, const Options &options) {
  VOXC_TRY(checkUsage(command, options));
  Stopwatch loading;
  auto volume = VOXC_TRY(Volume::load(options.volume, {.trusted = options.trusted}));
  auto kernel = VOXC_TRY(Kernel::load(options.kernel));
  Json figures;
  addVolumeFigures(figures, volume);
  figures["load_seconds"] = loading.seconds();
  auto device = VOXC_TRY(Device::open(options.device));
  Stopwatch upload;
  auto tracer = VOXC_TRY(createTracer(device, kernel, volume));
  figures["upload_seconds"] = upload.seconds();
  RayTally tally;
  ProgressBar bar(options.common.quiet);
  VOXC_TRY(options.rays.empty() ? takePicture(options, volume, *tracer, tally, bar, figures)
                                : traceRays(options, *tracer, tally, bar.progress()));
  tally.addFigures(figures, device.info().name);
  figures["driver"] = device.info().driver;
  figures["device_kind"] = device.info().kind;
  addRounds(figures, tally.times());
  return writeStatistics(options.common.stats, std::move(figures));
}

} // namespace

int main(int argc, char **argv) {
  const CommandLine command(
      "voxc-trace", "Traces rays through a volume, or takes a picture of it, with a compiled kernel.");
  Options options;
  addOptions(command, options);
  return runTool(command, argc, argv, [&] {
    // What is timed or counted is a picture's own rays, one a pixel.
    if ((options.repeat > 1 || options.count) && command.option("--style").count() == 0)
      options.picture.style = "flat";
    return run(command, options);
  });
}
