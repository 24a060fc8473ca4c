// The report of `voxc bench`: one HTML file that needs nothing else.
#pragma once

#include "report/Cells.h"
#include "report/SearchVerdict.h"

#include <map>
#include <string>
#include <vector>

namespace voxc::report {

/// What should be said of models, by their names: a sentence each.
using ModelNotes = std::map<std::string, std::string>;

struct Report {
  std::string html;
  std::string csv;                ///< The cells as comma-separated values, to be written beside the page.
  std::vector<std::string> notes; ///< What could not be shown, and why.
};

/// The report of these cells; pictures are read from where the records say. `csvName` is what the page's
/// link to the comma-separated values says; without it there is no link. `own` is the verdict of a search on
/// some of the cells, by one that has just ended; what others of `voxc search` say is found by the cells.
Report makeReport(const std::vector<Cell> &cells, const ModelNotes &modelNotes = {},
                  const std::string &csvName = {}, std::optional<SearchVerdict> own = {});

} // namespace voxc::report
