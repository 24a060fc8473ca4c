// Pictures for the driver.
#include "Rendering.h"

#include "Outputs.h"

#include "common/Png.h"
#include "voxc/IR/Query.h"
#include "voxc/Trace/Picture.h"

#include <vector>

namespace voxc::tool {

void Rendering::declare(CLI::App &app) {
  app.add_option("-o,--output", output_, "Picture to write, as PNG")->type_name("P.png")->required();
  app.add_flag("--heatmap", heatmap_, "Show the lookups that each ray took, with a legend");
  addCameraOptions(app, camera_);
  app.add_option(
         "--lod", lod_,
         "Stop at nodes and cells that look smaller than so many pixels, with a colour from inside; 0: "
         "at voxels alone")
      ->type_name("PIXELS")
      ->check(CLI::Range(0.0, 1e6).description(""));
  check_.declare(app);
}

Expected<void> Rendering::check(const CommonOptions &common) const {
  if (Expected<void> writable = checkOutput(output_, common); !writable)
    return writable;
  // Whatever the volume's extent will be, the options are right or wrong for any.
  Expected<Camera> camera = makeCamera(camera_, {1, 1, 1});
  return camera ? Expected<void>() : camera.error();
}

Expected<void> Rendering::applyTo(Format &format) const {
  const Outputs outputs = questionOf(format).outputs;
  if (!heatmap_ && !(outputs.voxel && outputs.t && outputs.colour))
    return Error::usage(
        "a picture is made of the voxel, t and colour of hits; leave out --query and --outputs, or ask "
        "for a --heatmap");
  if (lod_ > 0)
    format.setAttribute(kDetailAttribute, "cone");
  return {};
}

Expected<void> Rendering::render(const Volume &volume, Tracing &tracing, const Progress &progress,
                                 Json &figures) const {
  Expected<Camera> camera = makeCamera(camera_, volume.info().extent);
  if (!camera)
    return camera.error();
  const std::vector<Ray> rays = cameraRays(*camera);
  std::vector<Hit> hits(rays.size());
  const auto spread = static_cast<float>(lod_ * pixelSpread(*camera));
  if (Expected<void> traced = tracing.trace(
          rays, hits, {.countSteps = heatmap_, .spread = spread, .progress = progress}, figures);
      !traced)
    return traced;
  // No picture needs faces, and a heatmap has counts in their place.
  if (Expected<void> checked = check_.run(volume, rays, hits, {}, progress, figures); !checked)
    return checked;
  if (volume.layout().payload == Payload::Material && !heatmap_)
    showLabels(hits);
  figures["width"] = camera->width;
  figures["height"] = camera->height;
  return writePng(output_, heatmap_ ? heatmap(hits, camera->width, camera->height)
                                    : shade(rays, hits, camera->width, camera->height));
}

} // namespace voxc::tool
