// What a model's section is put together from.
#pragma once

#include "report/Catalogue.h"
#include "report/FrontierChart.h"

#include <string>
#include <vector>

namespace voxc::report {

/// A sentence for each question, with the command that builds its answer. The stages are of one model at one
/// resolution with the same rays.
std::string verdictHtml(const Catalogue &catalogue, const std::vector<const Stage *> &stages);

/// The same of a search: what it answers for all of its sets of rays together, in its own words.
std::string searchVerdictHtml(const SearchVerdict &verdict);

/// The chart of a stage, the table of its leaders, and what else is to be said of it; nothing if it has no
/// points. `isAlone`: no other figure stands beside it.
std::string stageFigure(const Catalogue &catalogue, const Stage &stage, const ChartRange &range,
                        bool isAlone);

/// The leaders of a stage from small to large, and why each stands where it does: lookups and words a ray,
/// and the bytes of each level.
std::string leaderTable(const Catalogue &catalogue, const Stage &stage);

/// The names of at most so many entries, as HTML: "G(8), R(4³) G(7) and 3 more".
std::string nameList(const std::vector<const Entry *> &entries, std::size_t most);

} // namespace voxc::report
