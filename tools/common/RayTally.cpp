// What traced rays come to.
#include "RayTally.h"

#include "voxc/Trace/SampleIndex.h"

#include <algorithm>

namespace voxc::tool {

void RayTally::add(const RaySpan &rays, std::span<const Hit> hits, const TraceReport &report, bool counted) {
  const RayCounts counts = countsOf(hits);
  counts_.rays += counts.rays;
  counts_.hits += counts.hits;
  counts_.steps += counts.steps;
  counted_ |= counted;
  report_.firstDispatch += report.firstDispatch;
  report_.transfer += report.transfer;
  report_.coarse += report.coarse;
  report_.binned |= report.binned;
  report_.choosing += report.choosing;
  report_.repeats.resize(std::max(report_.repeats.size(), report.repeats.size()));
  for (std::size_t i = 0; i < report.repeats.size(); ++i) {
    report_.repeats[i].wall += report.repeats[i].wall;
    report_.repeats[i].cpu += report.repeats[i].cpu;
    report_.repeats[i].device += report.repeats[i].device;
  }
  // Each call gives as many as all should; whoever checks them leaves some out.
  const std::size_t count = std::min(sample_, rays.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = sampleIndex(i, count, rays.size());
    sampledRays_.push_back(bounded(rays[at], rays.bounds(at)));
    sampledHits_.push_back(hits[at]);
  }
}

void RayTally::addFigures(Json &figures, const std::string &device) const {
  addTraceFigures(figures, report_, counts_, device, counted_);
}

} // namespace voxc::tool
