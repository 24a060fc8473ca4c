// What voxc search says at the end.
#pragma once

#include "search/SearchLoop.h"

#include "bench/SearchVerdict.h"
#include "common/Json.h"
#include "options/InputArguments.h"

#include <string>
#include <vector>

namespace voxc::tool {

/// The verdict on what a search measured; `cells` are the records of its folder, which must outlive it.
bench::SearchVerdict verdictOf(const std::vector<bench::Record> &cells, const SearchLoop &loop,
                               const std::string &objective);

struct SearchResult {
  std::string input;
  InputArguments arguments; ///< As they were looked at.
  std::string device;
  std::vector<std::string> rays; ///< Names of the sets.
  std::size_t rated = 0;         ///< Formats of which size and speed were predicted,
  std::size_t kept = 0;          ///< and those that came near the frontier.
  double seconds = 0;
  const Acquisition &acquisition;
  const SearchLoop &loop;
  const bench::SearchVerdict &verdict;
};

/// The frontier as a table, a line for each question that one may ask of it, and the command that builds what
/// the objective asks for.
std::string searchReport(const SearchResult &result);

/// Adds what was measured, how well it was predicted, and what the formats cost that came near the frontier.
void addSearchFigures(Json &figures, const SearchResult &result);

} // namespace voxc::tool
