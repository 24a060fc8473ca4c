// What voxc search says at the end.
#pragma once

#include "InputArguments.h"

#include "common/Json.h"
#include "search/Contest.h"
#include "voxc/Search/Suggest.h"

#include <string>
#include <vector>

namespace voxc::tool {

struct SearchResult {
  std::string input;
  InputArguments arguments; ///< As they were looked at.
  std::string device;
  Wish wish;
  std::vector<std::string> rays; ///< Names of the sets.
  std::size_t rated = 0;         ///< Formats of which size and speed were foretold,
  std::size_t kept = 0;          ///< and those that came near the frontier.
  double seconds = 0;
  const Race &race;
  const Contest &contest;
};

/// The number in the race of the measured format that the wish asks for; none of none.
std::optional<std::size_t> chosen(const SearchResult &result);

/// The frontier as a table, a line for each question that one may ask of it, and the command that builds what
/// the wish asks for.
std::string searchReport(const SearchResult &result);

/// Adds what was measured, how well it was foretold, and what the formats cost that came near the frontier.
void addSearchFigures(Json &figures, const SearchResult &result);

} // namespace voxc::tool
