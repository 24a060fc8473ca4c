// What traced rays come to, over all calls that trace them.
#pragma once

#include "Statistics.h"

#include <cstdint>
#include <span>
#include <vector>

namespace voxc::tool {

class RayTally {
public:
  /// Keeps so many rays of every call with their hits, evenly spread.
  explicit RayTally(std::size_t sample = 0) : sample_(sample) {}

  /// Counts rays that were traced; `counted`: with their lookups.
  void add(const RaySpan &rays, std::span<const Hit> hits, const TraceReport &report, bool counted);

  const RayCounts &counts() const { return counts_; }
  /// The share of rays that coarse blocks have answered.
  double coarseShare() const {
    return counts_.rays > 0 ? static_cast<double>(report_.coarse) / static_cast<double>(counts_.rays) : 0;
  }
  /// Of each repeat, the sum over the calls.
  const std::vector<TraceTime> &times() const { return report_.repeats; }
  std::span<const BoundedRay> sampledRays() const { return sampledRays_; }
  std::span<const Hit> sampledHits() const { return sampledHits_; }

  /// Adds the figures of tracing.
  void addFigures(Json &figures, const std::string &device) const;

private:
  std::size_t sample_;
  RayCounts counts_;
  bool counted_ = false;
  TraceReport report_;
  std::vector<BoundedRay> sampledRays_;
  std::vector<Hit> sampledHits_;
};

} // namespace voxc::tool
