// Figures of a run as JSON.
#include "Statistics.h"

#include "Files.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string_view>

namespace voxc::tool {
namespace {

/// Millions of rays a second; 0 where nothing was measured.
double mraysPer(double rays, double seconds) { return seconds > 0 ? rays / seconds * 1e-6 : 0; }

double smallest(const std::vector<TraceTime> &repeats, double TraceTime::*clock) {
  if (repeats.empty())
    return 0;
  return std::ranges::min(repeats, {}, clock).*clock;
}

} // namespace

void addVolumeFigures(Json &figures, const Volume &volume) {
  Int3 extent = volume.info().extent;
  figures["format"] = toString(volume.format());
  figures["extent"] = {extent.x, extent.y, extent.z};
  figures["words"] = volume.words().size();
  figures["bytes"] = volume.bytes();
  figures["voxels"] = volume.info().voxels;
}

RayCounts countsOf(std::span<const Hit> hits) {
  RayCounts counts{.rays = hits.size()};
  for (const Hit &hit : hits) {
    counts.hits += hit.isHit();
    counts.steps += hit.steps;
  }
  return counts;
}

void addTraceFigures(Json &figures, const TraceReport &report, const RayCounts &counts,
                     const std::string &device, bool counted) {
  double rays = static_cast<double>(counts.rays);
  double seconds = smallest(report.repeats, &TraceTime::wall);
  double cpuSeconds = smallest(report.repeats, &TraceTime::cpu);
  double deviceSeconds = smallest(report.repeats, &TraceTime::device);
  figures["device"] = device;
  figures["rays"] = counts.rays;
  figures["hits"] = counts.hits;
  figures["order"] = report.binned ? "binned" : "given";
  figures["order_choice_seconds"] = report.choosing;
  figures["repeats"] = report.repeats.size();
  figures["seconds"] = seconds;
  figures["cpu_seconds"] = cpuSeconds;
  figures["mrays_per_s"] = mraysPer(rays, seconds);
  figures["mrays_per_cpu_s"] = mraysPer(rays, cpuSeconds);
  if (deviceSeconds > 0) {
    figures["device_seconds"] = deviceSeconds;
    figures["mrays_per_device_s"] = mraysPer(rays, deviceSeconds);
  }
  figures["first_dispatch_seconds"] = report.firstDispatch;
  figures["transfer_seconds"] = report.transfer;
  if (counted)
    figures["steps_per_ray"] = counts.rays > 0 ? static_cast<double>(counts.steps) / rays : 0.0;
}

std::uint64_t peakResidentBytes() {
  // getrusage would do, but it takes in the process that this one was forked from, whatever it executes
  // since.
  constexpr std::string_view kKey = "VmHWM:";
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(kKey))
      return std::strtoull(line.c_str() + kKey.size(), nullptr, 10) * 1024;
  return 0;
}

Expected<void> writeStatistics(const std::string &path, Json figures) {
  if (path.empty())
    return {};
  figures["peak_rss_bytes"] = peakResidentBytes();
  return writeText(path, figures.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

} // namespace voxc::tool
