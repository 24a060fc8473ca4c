// Rays for a search.
#include "search/SearchRays.h"

#include "sweep/Model.h"
#include "voxc/Search/SampleRays.h"

namespace voxc::tool {

namespace {

/// Without others: a camera that sees everything, and rays from surface to surface, so that the answer is not
/// that of one view.
Expected<std::vector<bench::RaySet>> measuredRays(const SearchOptions &options, const Scene &scene) {
  bench::RayArguments arguments = options.rays;
  const bool isUsual = arguments.cameraFile.empty() && arguments.rayFiles.empty();
  if (arguments.size.empty() && arguments.cameraFile.empty())
    arguments.size = "480x270";
  auto sets = bench::readRaySets(arguments, bench::nameOfInput(options.input));
  if (!sets || !isUsual)
    return sets;
  std::vector<Ray> bounces = sampleBounces(scene.shape, sets->front().raysFor(scene.extent), options.seed);
  if (!bounces.empty())
    sets->push_back(bench::makeRaySet("bounced", std::move(bounces), arguments.order));
  return sets;
}

} // namespace

std::vector<RaySet> replayedRays(const Scene &scene, const std::vector<bench::RaySet> &measured) {
  std::vector<RaySet> sets;
  for (const bench::RaySet &set : measured)
    sets.push_back({set.part.name, set.camera ? sampleCamera(set.camera(scene.extent), kReplayedRays)
                                              : spreadPackets(set.rays)});
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
