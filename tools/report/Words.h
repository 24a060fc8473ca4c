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
/// "G(8), with whole-level-dedup, restart-sv".
std::string wholeName(const Entry &entry);
/// How an entry stands to the frontier: "Beaten by G(8), 1.30× as fast at 0.800× the size".
std::string standingWords(const Catalogue &catalogue, const Entry &entry);
/// What is shown of a point: a line each for its name, size, speed, errors, work and standing.
std::string pointNote(const Catalogue &catalogue, const Entry &entry);
/// "2048³" for a side, or nothing if it is not known.
std::string sideText(double resolution);
/// "inside, 2048³": the rays, where a model has several, and the side.
std::string resolutionTitle(const Stage &stage);
/// "2048³ on llvmpipe, exact steps", with the rays likewise.
std::string stageTitle(const Stage &stage);
/// "1,440,000 rays of camera inside; whole-level-dedup unless a name says otherwise".
std::string stageConditions(const Catalogue &catalogue, const Stage &stage);
/// The errors of all these entries in one clause.
std::string errorSummary(const Catalogue &catalogue, const std::vector<std::size_t> &entries);

} // namespace voxc::report
