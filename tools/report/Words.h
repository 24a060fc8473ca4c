// Sentences about cells that several sections say.
#pragma once

#include "report/Catalogue.h"

#include <string>
#include <vector>

namespace voxc::report {

/// "1.23 Mrays/CPU s, spread 2.1 %", with a warning if it was not steady.
std::string speedWords(const Entry &entry);
/// "missed 0, ghost 0, wrong 0 of 20,000 rays", or that none was checked.
std::string errorWords(const Entry &entry);
/// What is shown of a point: a line each for its name, size, speed, errors and work.
std::string pointNote(const Entry &entry);
/// "2048³" for a side, or nothing if it is not known.
std::string sideText(double resolution);
/// "2048³ on llvmpipe".
std::string stageTitle(const Stage &stage);
/// "exact steps, whole-level-dedup".
std::string stageConditions(const Stage &stage);
/// The errors of all these entries in one clause.
std::string errorSummary(const Catalogue &catalogue, const std::vector<std::size_t> &entries);

} // namespace voxc::report
