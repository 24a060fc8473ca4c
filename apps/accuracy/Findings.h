// What `voxc accuracy` found, and how it is told: tables and JSON. docs/bench.md describes the JSON.
#pragma once

#include "accuracy/Series.h"
#include "accuracy/Variant.h"

#include "common/Json.h"
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
  std::vector<std::unique_ptr<VariantCandidate>> candidates;
  std::vector<LodFinding> lods;
  std::vector<SeriesPoint> distances;
  std::vector<SeriesPoint> resolutions;
  unsigned rounds = 0;
};

/// The tables, to standard output.
void printTables(const Findings &findings);

/// The findings as `variants`, `lods` and `series`.
void addFindings(Json &figures, const Findings &findings);

/// What each candidate is called.
std::vector<std::string> labels(const Findings &findings);

} // namespace voxc::tool
