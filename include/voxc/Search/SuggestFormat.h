// The format that a scene asks for, in one call: candidates rated by simulated rays, and one of them chosen.
#pragma once

#include "voxc/Search/SearchScene.h"
#include "voxc/Search/Suggest.h"

#include <cstddef>
#include <string>
#include <vector>

namespace voxc {

struct SuggestOptions {
  Wish wish;
  std::vector<Candidate> candidates; ///< To choose from.
  std::vector<RaySet> rays;          ///< Those of `samplePackets`; empty: of a camera that sees everything,
                                     ///< and bounced ones.
};

struct FormatSuggestion {
  std::vector<std::string> rays;      ///< Names of the sets.
  std::vector<PredictedFormat> rated; ///< With nanoseconds for each set.
  std::size_t choice = 0;             ///< Of them.
};

/// Rates the candidates by the model of a device, and chooses. Errors: no candidate is of the scene's size or
/// takes as few bytes as is wished (`Input`); `Interrupted`.
Expected<FormatSuggestion> suggestFormat(const SearchScene &scene, SuggestOptions options,
                                         const SpeedModel &model, const Progress &progress = {});

} // namespace voxc
