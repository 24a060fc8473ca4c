// The cells of a search, as records know them, and cut into shares.
#pragma once

#include "choosing/Scene.h"
#include "sweep/Cells.h"
#include "sweep/SharedSweep.h"
#include "voxc/Search/FormatPredictor.h"

#include <cstdint>
#include <vector>

namespace voxc::tool {

/// The records that a format would have, without figures. The formats of the axes, which have one model with
/// its rays, one precision and one device, become this one.
std::vector<measure::Record> recordsOf(const Candidate &format, bench::SweepAxes &axes,
                                       const measure::MadeByPart &madeBy);

/// Keeps the candidates of a share alone: a run of them, as long as the others.
void keepShare(std::vector<Candidate> &candidates, const bench::Share &share);

/// A digest of a search for candidates: what share files and jobs are known by.
std::string searchDigest(const std::vector<Candidate> &candidates, const bench::SweepAxes &axes);

/// The cells of `formats`, which are candidates that are worth a volume, by the shares of the candidates.
bench::SharedCells sharedCells(const std::vector<PredictedFormat> &formats,
                               const std::vector<Candidate> &candidates, std::uint64_t count,
                               bench::SweepAxes &axes);

} // namespace voxc::tool
