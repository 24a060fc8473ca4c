// A whole prediction in one call.
#include "Measure/QuestionWish.h"
#include "voxc/Measure/SavedWeights.h"
#include "voxc/Search/SampleRays.h"
#include "voxc/Search/SuggestFormat.h"

#include <algorithm>

namespace voxc {
namespace {

FormatTable tableOf(const SearchScene &scene, const FormatSuggestion &suggestion) {
  FormatTable table{.voxels = scene.voxels, .sets = suggestion.rays};
  const std::vector<bool> frontier = frontierOf(suggestion.rated);
  for (std::size_t i = 0; i < suggestion.rated.size(); ++i) {
    const PredictedFormat &format = suggestion.rated[i];
    FormatRow &row = table.rows.emplace_back(FormatRow{.format = format.candidate.text,
                                                       .passes = format.candidate.passes,
                                                       .bytes = format.bytes(),
                                                       .isExact = format.price.exact,
                                                       .isOnFrontier = frontier[i],
                                                       .isChosen = i == suggestion.choice});
    for (const double nanoseconds : format.nanoseconds)
      row.speeds.push_back({.predicted = nanoseconds > 0 ? 1e9 / nanoseconds : 0});
  }
  return table;
}

} // namespace

namespace measure {

Expected<Wish> wishOf(const FormatQuestion &question) {
  const auto objective = fromString<Wish::Objective>(question.objective);
  if (!objective)
    return Error::usage("'" + question.objective +
                        "' is no objective; those are balanced, fastest and smallest");
  if (!question.rays.empty() && question.rays.size() < kSimulatedPacket)
    return Error::usage("there are " + std::to_string(question.rays.size()) + " rays; " +
                        std::to_string(kSimulatedPacket) + " or more show what a packet costs");
  const std::uint64_t most = kMaxWords * sizeof(std::uint32_t);
  return Wish{*objective, question.maxBytes > 0 ? std::min(question.maxBytes, most) : most};
}

} // namespace measure

Expected<FormatTable> suggestFormats(const SourceOpener &open, const FormatQuestion &question,
                                     const Progress &progress) {
  const auto wish = VOXC_TRY(measure::wishOf(question));
  VOXC_TRY(measure::checkSpeedsKnown(question.device));
  const auto memory = question.memory ? question.memory : WorkingMemory::createDefault();
  auto scene = VOXC_TRY(readSearchScene(question.name, open, memory, progress));
  scene.traits.editable = question.editable;
  auto candidates = VOXC_TRY(candidatesOf(question.formats, scene));
  std::vector<RaySet> rays;
  const int longestEdge = std::max({scene.extent.x, scene.extent.y, scene.extent.z});
  if (!question.rays.empty())
    rays.push_back(samplePackets("rays", question.rays, kConsideredRays, longestEdge, RayOrder::Auto));
  const auto suggested = VOXC_TRY(
      suggestFormat(scene, {.wish = wish, .candidates = std::move(candidates), .rays = std::move(rays)},
                    measure::knownSpeedsOf(question.device).model, progress));
  return tableOf(scene, suggested);
}

} // namespace voxc
