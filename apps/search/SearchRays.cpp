// Rays for a search.
#include "search/SearchRays.h"

#include "sweep/Model.h"
#include "voxc/Measure/FormatSearch.h"

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
  if (auto bounced = measure::bouncedSet(scene, eye, options.seed, rayOrderFrom(arguments.order)))
    sets->push_back({.part = std::move(bounced->part), .camera = {}, .rays = std::move(bounced->rays)});
  return sets;
}

} // namespace

std::vector<measure::MeasuredSet> measuredSets(const Scene &scene, const bench::SweepAxes &axes) {
  std::vector<measure::MeasuredSet> sets;
  for (const bench::RaySet &set : axes.models.front().rays)
    sets.push_back({set.part, set.raysFor(scene.extent),
                    set.camera ? std::optional(set.camera(scene.extent)) : std::nullopt});
  return sets;
}

Expected<bench::SweepAxes> makeSearchAxes(const SearchOptions &options, const Scene &scene) {
  auto model = VOXC_TRY(bench::readModel(options.input, options.inputArguments));
  auto rays = VOXC_TRY(measuredRays(options, scene));
  auto devices = VOXC_TRY(bench::findDevices({options.device}, options.building.threads));
  for (const bench::RaySet &set : rays)
    VOXC_TRY(bench::keepRays(set, options.folder + "/cache"));
  std::vector<bench::SweepModel> models;
  models.push_back({std::move(model), std::move(rays)});
  return bench::SweepAxes{std::move(models), {}, {options.precision}, std::move(devices)};
}

} // namespace voxc::tool
