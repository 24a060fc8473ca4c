// Suggesting a format for an input.
#include "choosing/Suggestion.h"

#include "common/Files.h"
#include "voxc/Measure/SavedWeights.h"
#include "voxc/Search/SampleRays.h"
#include "voxc/Support/Stopwatch.h"

#include <algorithm>

namespace voxc::tool {

namespace {

Expected<std::vector<RaySet>> readRaySets(const std::vector<std::string> &paths, const Scene &scene) {
  const int longestEdge = std::max({scene.extent.x, scene.extent.y, scene.extent.z});
  std::vector<RaySet> sets;
  for (const std::string &path : paths) {
    auto rays = VOXC_TRY(readRays(path));
    if (rays.size() < kSimulatedPacket)
      return Error::input("'" + path + "' has " + std::to_string(rays.size()) + " rays; " +
                          std::to_string(kSimulatedPacket) + " or more show what a packet costs");
    sets.push_back(samplePackets(path, std::move(rays), kConsideredRays, longestEdge, RayOrder::Auto));
  }
  return sets;
}

} // namespace

Expected<Suggestion> makeSuggestion(const SuggestRequest &request, const CommonOptions &common,
                                    const Progress &progress, Json &figures) {
  InputArguments arguments = request.arguments;
  VOXC_TRY(checkInputArguments(arguments, request.input));
  fillResolution(arguments, request.input);
  InputOptions options = sceneOptions(arguments, request.memory, progress);
  options.boxOfAllFrames = request.hasAllFrames;
  auto scene = VOXC_TRY(readScene(request.input, options, common, figures));
  scene.traits.editable = request.editable || request.hasAllFrames; // What excludes edits excludes frames.
  if (request.hasAllFrames)
    scene.traits.oneColour = scene.traits.visible = false; // Other frames may have others.
  auto candidates = VOXC_TRY(readCandidates(request.formatList, scene));
  auto rays = VOXC_TRY(readRaySets(request.rayFiles, scene));
  noteOtherSizes(candidates, scene, common);
  const measure::KnownSpeeds speeds = measure::knownSpeedsOf(request.device);
  const Stopwatch watch;
  auto suggested = suggestFormat(
      scene, {.wish = request.wish, .candidates = std::move(candidates), .rays = std::move(rays)},
      speeds.model, progress);
  figures["rate_seconds"] = watch.seconds();
  if (!suggested)
    return suggested.error();
  return Suggestion{std::move(*suggested), request.input, std::move(arguments), request.device,
                    std::move(scene.told), scene.voxels,  scene.valueWords,     speeds.isMeasured};
}

} // namespace voxc::tool
