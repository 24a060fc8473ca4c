// Rays of pictures, counted.
#include "pictures/PictureRays.h"

namespace voxc::tool {

auto PictureRays::through(RayTally &tally) {
  return [this, &tally](std::span<const Ray> rays, std::span<Hit> hits,
                        const TraceOptions &options) -> Expected<void> {
    const std::vector<BoundedRay> kept =
        clip_.cutsNothing() ? std::vector<BoundedRay>() : clip_.bounded(rays, tracing_.threads());
    const RaySpan traced = clip_.cutsNothing() ? RaySpan(rays) : RaySpan(kept);
    auto report = VOXC_TRY(tracing_.trace(traced, hits, options));
    tally.add(traced, hits, report, options.countSteps);
    return {};
  };
}

Expected<PlacedCamera> PictureRays::findCamera(const PictureOptions &options, const Volume &volume) {
  RayTally finder;
  return placeCamera(options, volume, through(finder));
}

Expected<TakenPicture> PictureRays::take(const Volume &volume, const PlacedCamera &placed,
                                         RenderOptions options) {
  const auto eye = through(eye_), light = through(light_);
  options.threads = tracing_.threads();
  options.clip = clip_.cutsNothing() ? nullptr : &clip_;
  auto rendering = VOXC_TRY(voxc::render(volume, placed.camera, {eye, light}, options));
  return TakenPicture{std::move(rendering), placed};
}

void PictureRays::addFigures(Json &figures) const {
  eye_.addFigures(figures, tracing_.deviceInfo().name);
  tracing_.addPagingFigures(figures);
  const bool isCoarse = paging() && paging()->coarseSide > 0;
  if (isCoarse)
    figures["coarse_share"] = eye_.coarseShare();
  if (light_.counts().rays > 0) {
    figures["light_rays"] = light_.counts().rays;
    figures["light_seconds"] = light_.times().front().wall;
    if (isCoarse)
      figures["light_coarse_share"] = light_.coarseShare();
  }
}

} // namespace voxc::tool
