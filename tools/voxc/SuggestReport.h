// What voxc suggest says.
#pragma once

#include "InputArguments.h"

#include "common/Json.h"
#include "voxc/Search/Suggest.h"

#include <string>
#include <vector>

namespace voxc::tool {

struct Suggestion {
  std::string input;
  InputArguments arguments; ///< As they are looked at.
  std::string device;
  Wish wish;
  std::uint64_t voxels = 0;
  std::uint64_t valueWords = 0;  ///< Of values apart.
  std::vector<std::string> rays; ///< Names of the sets.
  std::vector<RatedFormat> rated;
  std::optional<std::size_t> choice;
};

/// The choice, two lines of why, and the command that builds it; with `all`, a table of the frontier.
std::string suggestReport(const Suggestion &suggestion, bool all);

/// Adds every format that was looked at, the frontier marked, as JSON.
void addSuggestFigures(Json &figures, const Suggestion &suggestion);

} // namespace voxc::tool
