// Suggesting a format.
#include "choosing/Suggestion.h"

#include "choosing/SavedWeights.h"

#include "common/Files.h"
#include "voxc/Search/SampleRays.h"
#include "voxc/Support/Stopwatch.h"

#include <algorithm>

namespace voxc::tool {

namespace {

/// A picture in which neighbours are as close as in one of the default size, and packets lie everywhere.
constexpr int kWidth = 1280;
constexpr int kHeight = 720;
/// Rays that bounce, of which some are simulated: as many as make bins of neighbours.
constexpr std::size_t kBounces = std::size_t{1} << 17;

Expected<std::vector<RaySet>> makeRays(const SuggestRequest &request, const Scene &scene) {
  std::vector<RaySet> sets;
  const int edge = std::max({scene.extent.x, scene.extent.y, scene.extent.z});
  for (const std::string &path : request.rayFiles) {
    Expected<std::vector<Ray>> rays = readRays(path);
    if (!rays)
      return rays.error();
    if (rays->size() < kSimulatedPacket)
      return Error::input("'" + path + "' has " + std::to_string(rays->size()) + " rays; " +
                          std::to_string(kSimulatedPacket) + " or more show what a packet costs");
    sets.push_back(samplePackets(path, std::move(*rays), kConsideredRays, edge, RayOrder::Auto));
  }
  if (sets.empty()) {
    sets.push_back({"camera", sampleCamera(frameExtent(scene.extent, kWidth, kHeight), kConsideredRays)});
    std::vector<Ray> bounces = sampleBounces(scene.shape, sets.front().rays, kBounces, 1);
    if (!bounces.empty()) // Something is seen.
      sets.push_back(samplePackets("bounced", std::move(bounces), kConsideredRays, edge, RayOrder::Auto));
  }
  for (RaySet &set : sets)
    set = typicalPackets(scene.shape, set, kSimulatedRays);
  return sets;
}

} // namespace

Expected<Suggestion> makeSuggestion(const SuggestRequest &request, const CommonOptions &common,
                                    const Progress &progress, Json &figures) {
  Suggestion suggestion{
      .input = request.input, .arguments = request.arguments, .device = request.device, .wish = request.wish};
  fillResolution(suggestion.arguments, request.input);
  Expected<Scene> scene =
      readScene(request.input, suggestion.arguments, request.memory, common, progress, figures);
  if (!scene)
    return scene.error();
  scene->traits.editable = request.editable;
  Expected<std::vector<Candidate>> candidates = readCandidates(request.formatList, *scene);
  if (!candidates)
    return candidates.error();
  Expected<std::vector<RaySet>> rays = makeRays(request, *scene);
  if (!rays)
    return rays.error();
  noteOtherSizes(*candidates, *scene, common);
  const Error none = explainNone(*candidates, *scene);
  const Stopwatch watch;
  for (const RaySet &set : *rays)
    suggestion.rays.push_back(set.name);
  suggestion.told = scene->told;
  suggestion.voxels = scene->voxels;
  suggestion.valueWords = scene->valueWords;
  const KnownSpeeds speeds = knownSpeedsOf(request.device);
  suggestion.areSpeedsMeasured = speeds.isMeasured;
  auto rated =
      predictFormats(scene->priced(), std::move(*candidates), *rays, speeds.model, request.wish, progress);
  figures["rate_seconds"] = watch.seconds();
  if (!rated)
    return rated.error();
  suggestion.rated = std::move(*rated);
  suggestion.choice = choose(suggestion.rated, request.wish);
  if (!suggestion.choice)
    return none;
  return suggestion;
}

} // namespace voxc::tool
