// Suggesting a format.
#include "voxc/Search/SuggestFormat.h"

#include "voxc/Search/SampleRays.h"

#include <algorithm>

namespace voxc {
namespace {

/// A picture in which neighbours are as close as in one of the default size, and packets lie everywhere.
constexpr int kWidth = 1280;
constexpr int kHeight = 720;
/// Rays that bounce, of which some are simulated: as many as make bins of neighbours.
constexpr std::size_t kBounces = std::size_t{1} << 17;

std::vector<RaySet> defaultRays(const SearchScene &scene) {
  const int longestEdge = std::max({scene.extent.x, scene.extent.y, scene.extent.z});
  std::vector<RaySet> sets;
  sets.push_back({"camera", sampleCamera(frameExtent(scene.extent, kWidth, kHeight), kConsideredRays)});
  std::vector<Ray> bounces = sampleBounces(scene.shape, sets.front().rays, kBounces, 1);
  if (!bounces.empty()) // Something is seen.
    sets.push_back(
        samplePackets("bounced", std::move(bounces), kConsideredRays, longestEdge, RayOrder::Auto));
  return sets;
}

} // namespace

Expected<FormatSuggestion> suggestFormat(const SearchScene &scene, SuggestOptions options,
                                         const SpeedModel &model, const Progress &progress) {
  std::vector<RaySet> rays = options.rays.empty() ? defaultRays(scene) : std::move(options.rays);
  FormatSuggestion suggestion;
  for (RaySet &set : rays) {
    set = typicalPackets(scene.shape, set, kSimulatedRays);
    suggestion.rays.push_back(set.name);
  }
  const Error none = explainNone(options.candidates, scene);
  suggestion.rated = VOXC_TRY(
      predictFormats(scene.modelled(), std::move(options.candidates), rays, model, options.wish, progress));
  const auto choice = choose(suggestion.rated, options.wish);
  if (!choice)
    return none;
  suggestion.choice = *choice;
  return suggestion;
}

} // namespace voxc
