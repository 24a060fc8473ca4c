// Figures of a run as JSON.
#pragma once

#include "Json.h"

#include "voxc/Support/Error.h"
#include "voxc/Support/Stopwatch.h"
#include "voxc/Trace/Ray.h"
#include "voxc/Trace/Tracer.h"
#include "voxc/Volume/Volume.h"

#include <span>
#include <string>

namespace voxc::tool {

/// Adds format, extent, words, bytes and voxels.
void addVolumeFigures(Json &figures, const Volume &volume);

/// What rays came to.
struct RayCounts {
  std::uint64_t rays = 0;
  std::uint64_t hits = 0;
  std::uint64_t steps = 0; ///< Lookups of all rays, if they were counted.
};
RayCounts countsOf(std::span<const Hit> hits);

/// Adds device, rays, hits, repeats, seconds, cpu_seconds, device_seconds where the device has a clock, the
/// three speeds that follow from them, first_dispatch_seconds, transfer_seconds and, if lookups were
/// `counted`, steps_per_ray. Each time is the smallest of the repeats.
void addTraceFigures(Json &figures, const TraceReport &report, const RayCounts &counts,
                     const std::string &device, bool counted);

/// The largest memory of this process so far, in bytes.
std::uint64_t peakResidentBytes();

/// Adds peak_rss_bytes and writes the figures to `path`: "-" is standard output, "" writes nothing. Error:
/// nothing can be written there (`Environment`).
Expected<void> writeStatistics(const std::string &path, Json figures);

} // namespace voxc::tool
