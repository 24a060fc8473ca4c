// Checking a sample of traced rays.
#include "tracing/ErrorCheck.h"

#include "voxc/Trace/SampleIndex.h"

#include <algorithm>
#include <vector>

namespace voxc::tool {

Json errorJson(const ErrorFigures &error) {
  return {{"rays", error.rays},    {"missed", error.missed}, {"ghost", error.ghost},
          {"wrong", error.wrong},  {"colour", error.colour}, {"boundary", error.boundary},
          {"max_dt", error.maxDt}, {"rms_dt", error.rmsDt},  {"max_ulp_dt", error.maxUlpDt}};
}

void ErrorCheck::declare(const CommandLine &command) {
  command.add("--check", sample_, "Rays, evenly spread, whose hits are compared with the exact oracle's")
      .takes("N")
      .showsDefault();
}

Expected<void> ErrorCheck::run(const Volume &volume, const RaySpan &rays, std::span<const Hit> hits,
                               const Question &question, const Progress &progress, Json &figures) const {
  const std::size_t count = std::min(sample_, rays.size());
  if (count == 0)
    return {};
  const auto oracle = VOXC_TRY(Oracle::of(volume, progress));
  std::vector<BoundedRay> sampledRays(count);
  std::vector<Hit> sampledHits(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = sampleIndex(i, count, rays.size());
    sampledRays[i] = bounded(rays[at], rays.bounds(at));
    sampledHits[i] = hits[at];
  }
  figures["error"] = errorJson(compare(oracle, sampledRays, sampledHits, question));
  return {};
}

} // namespace voxc::tool
