// What voxc search says at the end.
#pragma once

#include "common/Json.h"
#include "options/InputArguments.h"
#include "voxc/Measure/FormatSearch.h"

#include <string>
#include <vector>

namespace voxc::tool {

struct SearchResult {
  std::string input;
  InputArguments arguments; ///< As they were looked at.
  std::string device;
  std::vector<std::string> rays; ///< Names of the sets.
  std::size_t rated = 0;         ///< Formats of which size and speed were predicted,
  std::size_t kept = 0;          ///< and those that came near the frontier.
  double seconds = 0;
  bool isInterrupted = false; ///< By the user, before the budget ended.
  double leastSpeed = 0;      ///< That was asked for, in million rays a second.
  const Acquisition &acquisition;
  const measure::SearchLoop &loop;
  const measure::SearchVerdict &verdict;
};

/// The frontier as a table, a line for each question that one may ask of it, and the command that builds what
/// the objective asks for; without an answer, how much was looked at.
std::string searchReport(const SearchResult &result);

/// Why there is no answer. Precondition: the frontier is empty.
std::string whyNoAnswer(const SearchResult &result);

/// Adds what was measured, how well it was predicted, and what the formats cost that came near the frontier.
void addSearchFigures(Json &figures, const SearchResult &result);

} // namespace voxc::tool
