// A format for an input, without building any: what `suggest` tells, and what a FORMAT of `auto` takes.
#pragma once

#include "choosing/Scene.h"

#include "voxc/Search/SuggestFormat.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace voxc::tool {

struct SuggestRequest {
  std::string input;
  InputArguments arguments;  ///< Without a resolution it is the default.
  bool hasAllFrames = false; ///< Formats hold every frame of an animation; they are rated by the first one.
  Wish wish;
  bool editable = false; ///< Only formats that can be edited in place.
  std::string device = "cpu";
  std::vector<std::string> rayFiles; ///< None: sampled rays.
  std::string formatList;            ///< "": formats that voxc knows.
  std::shared_ptr<WorkingMemory> memory;
};

struct Suggestion : FormatSuggestion {
  std::string input;
  InputArguments arguments; ///< As they are looked at.
  std::string device;
  ToldSentences told; ///< Of the input.
  std::uint64_t voxels = 0;
  std::uint64_t valueWords = 0;   ///< Of values apart.
  bool areSpeedsMeasured = false; ///< The model of speeds is of this machine, by a search.
};

/// Reads the input, rates formats and chooses. Figures of it are added. Errors: those of inputs and ray
/// files; no format takes as few bytes as is wished; interrupted.
Expected<Suggestion> makeSuggestion(const SuggestRequest &request, const CommonOptions &common,
                                    const Progress &progress, Json &figures);

} // namespace voxc::tool
