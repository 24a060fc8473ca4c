// What `voxc accuracy` found, and how it is told: tables, JSON, plots. docs/accuracy.md describes the JSON.
#pragma once

#include "accuracy/Series.h"
#include "accuracy/Variant.h"

#include "common/PictureDifference.h"

#include <string>
#include <vector>

namespace voxc::tool {

/// One level of deliberate approximation against none.
struct LodFinding {
  double pixels = 0;
  double mraysPerCpuSecond = 0;
  double speedUp = 1;
  bool equal = false; ///< As fast as without, as far as the repeats can tell.
  PictureDifference picture;
};

struct Findings {
  std::string subject; ///< The volume's format and the rays, for headings.
  std::vector<std::unique_ptr<Contestant>> contestants;
  std::vector<LodFinding> lods;
  std::vector<SeriesPoint> distances;
  std::vector<SeriesPoint> resolutions;
  unsigned rounds = 0;
};

/// The tables, to standard output.
void printTables(const Findings &findings);

/// The findings as `variants`, `lods` and `series`.
void addFindings(Json &figures, const Findings &findings);

/// Writes the plots of what there is to the folder: accuracy.svg, lod.svg, and of each series NAME-error.svg
/// and NAME-speed.svg. Errors: as `writeText`.
Expected<void> writePlots(const Findings &findings, const std::string &folder);

/// What each contestant is called.
std::vector<std::string> labels(const Findings &findings);

} // namespace voxc::tool
