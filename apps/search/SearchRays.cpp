// Rays for a search.
#include "search/SearchRays.h"

#include "sweep/Model.h"
#include "voxc/Search/SampleRays.h"

#include <algorithm>

namespace voxc::tool {

namespace {

/// Without others: a camera that sees everything, and rays from surface to surface, so that the answer is not
/// that of one view.
Expected<std::vector<bench::RaySet>> measuredRays(const SearchOptions &options, const Scene &scene) {
  bench::RayArguments arguments = options.rays;
  const bool hasDefaultRays = arguments.cameraFile.empty() && arguments.rayFiles.empty();
  if (arguments.size.empty() && arguments.cameraFile.empty())
    arguments.size = "480x270";
  auto sets = bench::readRaySets(arguments, bench::nameOfInput(options.input));
  if (!sets || !hasDefaultRays)
    return sets;
  const std::vector<Ray> eye = sets->front().raysFor(scene.extent);
  std::vector<Ray> bounces = sampleBounces(scene.shape, eye, eye.size(), options.seed);
  if (!bounces.empty())
    sets->push_back(bench::makeRaySet("bounced", std::move(bounces), arguments.order));
  return sets;
}

} // namespace

std::vector<RaySet> simulatedRays(const Scene &scene, const bench::SweepAxes &axes) {
  // A tracer of a device that is no processor takes rays as they are given.
  const bool isProcessor = axes.devices.front().part.clock == "cpu";
  std::vector<RaySet> sets;
  for (const bench::RaySet &set : axes.models.front().rays) {
    RayOrder order = rayOrderFrom(set.part.order.value_or(kAutoOrder));
    if (order == RayOrder::Auto && (set.camera || !isProcessor))
      order = RayOrder::Given;
    const RaySet considered =
        set.camera && order == RayOrder::Given
            ? RaySet{set.part.name, sampleCamera(set.camera(scene.extent), kConsideredRays)}
            : samplePackets(set.part.name, set.raysFor(scene.extent), kConsideredRays,
                            std::max({scene.extent.x, scene.extent.y, scene.extent.z}), order);
    sets.push_back(typicalPackets(scene.shape, considered, kSimulatedRays));
  }
  return sets;
}

Expected<bench::SweepAxes> makeSearchAxes(const SearchOptions &options, const Scene &scene) {
  auto model = bench::readModel(options.input, options.inputArguments);
  if (!model)
    return model.error();
  auto rays = measuredRays(options, scene);
  if (!rays)
    return rays.error();
  auto devices = bench::findDevices({options.device}, options.building.threads);
  if (!devices)
    return devices.error();
  for (const bench::RaySet &set : *rays)
    if (Expected<void> kept = bench::keepRays(set, options.folder + "/cache"); !kept)
      return kept.error();
  std::vector<bench::SweepModel> models;
  models.push_back({std::move(*model), std::move(*rays)});
  return bench::SweepAxes{std::move(models), {}, {options.precision}, std::move(*devices)};
}

} // namespace voxc::tool
