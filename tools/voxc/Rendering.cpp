// Pictures for the driver.
#include "Rendering.h"

#include "Figures.h"
#include "Outputs.h"

#include "common/PictureFile.h"
#include "common/RayTally.h"
#include "common/Statistics.h"
#include "voxc/IR/Query.h"

#include <filesystem>

namespace voxc::tool {

void Rendering::declare(const CommandLine &command) {
  command
      .add("-o,--output", output_,
           "Picture to write, as " + pictureEndings() +
               "; the default is named after the input and the style")
      .takes("PICTURE");
  addPictureOptions(command, picture_);
  command
      .add("--lod", picture_.lod,
           "Stop at nodes and cells that look smaller than so many pixels, with a colour from inside; 0: "
           "at voxels alone")
      .takes("PIXELS")
      .between(0.0, 1e6);
  check_.declare(command);
}

Expected<void> Rendering::check(const std::string &source, const CommonOptions &common) {
  if (output_.empty()) {
    const std::string stem = std::filesystem::path(source.substr(source.rfind(':') + 1)).stem().string();
    output_ = (stem.empty() ? "picture" : stem) + "-" + std::string(toString(styleOf(picture_))) + ".png";
  }
  if (Expected<void> writable = checkOutput(output_, common); !writable)
    return writable;
  if (Expected<void> named = checkPictureName(output_); !named)
    return named;
  return checkPictureOptions(picture_);
}

Expected<void> Rendering::applyTo(Format &format) const {
  const Outputs outputs = questionOf(format).outputs;
  if (styleOf(picture_) != Style::Heatmap && !(outputs.voxel && outputs.t && outputs.colour))
    return Error::usage(
        "a picture is made of the voxel, t and colour of hits; leave out --query and --outputs, or ask "
        "for a --heatmap");
  if (picture_.lod > 0)
    format.setAttribute(kDetailAttribute, "cone");
  return {};
}

Expected<void> Rendering::render(const Volume &volume, Tracing &tracing, const CommonOptions &common,
                                 ProgressBar &bar, Json &figures) const {
  const Stopwatch watch;
  RayTally eye(check_.rays()), light, finder;
  const auto through = [&tracing](RayTally &tally) {
    return [&tracing, &tally](std::span<const Ray> rays, std::span<Hit> hits,
                              const TraceOptions &options) -> Expected<void> {
      Expected<TraceReport> report = tracing.trace(rays, hits, options);
      if (!report)
        return report.error();
      tally.add(rays, hits, *report, options.countSteps);
      return {};
    };
  };
  const auto camera = through(eye), occlusion = through(light), probe = through(finder);
  Expected<TakenPicture> taken =
      takePicture(picture_, volume, {camera, occlusion}, probe, tracing.threads(), bar.progress());
  if (!taken)
    return taken.error();
  eye.addFigures(figures, tracing.deviceInfo().name);
  tracing.addPagingFigures(figures);
  if (light.counts().rays > 0) {
    figures["light_rays"] = light.counts().rays;
    figures["light_seconds"] = light.times().front().wall;
  }
  // No picture needs faces, and a heatmap has counts in their place.
  if (Expected<void> checked =
          check_.run(volume, eye.sampledRays(), eye.sampledHits(), {}, bar.progress(), figures);
      !checked)
    return checked;
  figures["width"] = taken->camera.width;
  figures["height"] = taken->camera.height;
  figures["style"] = toString(styleOf(picture_));
  figures["camera"] = cameraText(picture_, taken->camera, volume);
  figures["exposure"] = taken->rendering.exposure;
  figures["nearest_voxels"] = taken->rendering.nearest;
  figures["median_voxels"] = taken->rendering.middle;
  if (Expected<void> written = writeTaken(output_, *taken); !written)
    return written;
  addWritten(figures, output_);
  figures["render_seconds"] = watch.seconds();
  bar.clear();
  if (const auto warning = cameraWarning(*taken, volume); warning && !common.quiet)
    printNote("warning: " + *warning);
  return {};
}

} // namespace voxc::tool
