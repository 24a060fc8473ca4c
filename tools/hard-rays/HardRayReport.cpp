// Adding up what came of hard rays, and telling it.
#include "hard-rays/HardRayReport.h"

#include "hard-rays/HardRayFormats.h"

#include "tracing/ErrorCheck.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>

namespace voxc::tool {

namespace {

constexpr std::size_t kMostKept = 40;
constexpr std::size_t kMostKeptAtOnce = 2;

ErrorFigures &entry(std::vector<std::pair<std::string, ErrorFigures>> &figures, const std::string &name) {
  const auto found = std::ranges::find(figures, name, &std::pair<std::string, ErrorFigures>::first);
  return found != figures.end() ? found->second : figures.emplace_back(name, ErrorFigures{}).second;
}

void printRow(const std::string &name, const ErrorFigures &error) {
  std::printf("%-14s %12" PRIu64 " %9" PRIu64 " %9" PRIu64 " %9" PRIu64 " %9" PRIu64 " %9" PRIu64
              " %9.3g %9.3g\n",
              name.c_str(), error.rays, error.missed, error.ghost, error.wrong, error.colour, error.boundary,
              error.maxUlpDt, error.maxDt);
}

Json rowsOf(const std::vector<std::pair<std::string, ErrorFigures>> &figures) {
  Json rows = Json::object();
  for (const auto &[name, error] : figures)
    rows[name] = errorJson(error);
  return rows;
}

} // namespace

CorpusRay corpusRay(const RaySet &set, std::size_t index) {
  return {set.scene, set.extent, set.rays[index],
          set.isBounded() ? std::optional(set.bounds[index]) : std::nullopt, set.exact[index]};
}

std::vector<BoundedRay> RaySet::boundedRays() const {
  std::vector<BoundedRay> result;
  result.reserve(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i)
    result.push_back(bounded(rays[i], isBounded() ? bounds[i] : RayBounds{}));
  return result;
}

std::uint64_t HardRayReport::failuresOf(const ErrorFigures &error) const {
  const std::uint64_t wrong = error.differences() - (rules_.allowBoundary ? error.boundary : 0);
  // Of rays whose t is too far off only the worst is known.
  return wrong + (rules_.maxUlp && error.maxUlpDt > *rules_.maxUlp ? 1 : 0);
}

void HardRayReport::keep(const RaySet &set, std::size_t index, const Hit &hit, const Failure &failure) {
  if (kept_.size() == kMostKept)
    return;
  kept_.push_back(failure);
  kept_.back().ray = corpusRay(set, index);
  kept_.back().kernel = hit;
}

void HardRayReport::add(const RaySet &set, const Oracle &oracle, std::span<const Hit> hits,
                        const Format &format, const std::string &device) {
  const std::vector<BoundedRay> rays = set.boundedRays();
  for (const RaySet::Part &part : set.parts) {
    const ErrorFigures error = compare(oracle, std::span(rays).subspan(part.begin, part.count),
                                       std::span(set.exact).subspan(part.begin, part.count),
                                       hits.subspan(part.begin, part.count), questionOf(format));
    entry(classes_, part.name).append(error);
    entry(devices_, device).append(error);
    total_.append(error);
    const std::uint64_t failed = failuresOf(error);
    failed_ += failed;
    if (failed == 0 || kept_.size() == kMostKept)
      continue;
    std::vector<std::uint64_t> worst;
    for (const std::uint64_t index : error.examples)
      if (worst.size() < kMostKeptAtOnce)
        worst.push_back(index);
    if (rules_.maxUlp && error.maxUlpDt > *rules_.maxUlp)
      worst.push_back(error.latest);
    for (const std::uint64_t index : worst)
      keep(set, part.begin + index, hits[part.begin + index], {oneLine(format), device, part.name, {}, {}});
  }
}

std::optional<Error> HardRayReport::verdict() const {
  if (failed_ == 0)
    return std::nullopt;
  return Error::input("the kernels' hits differ from the oracle's on " + std::to_string(failed_) + " of " +
                      std::to_string(total_.rays) + " rays");
}

void HardRayReport::print() const {
  std::printf("%-14s %12s %9s %9s %9s %9s %9s %9s %9s\n", "class", "rays", "missed", "ghost", "wrong",
              "colour", "boundary", "max_ulp", "max_dt");
  for (const auto &[name, error] : classes_)
    printRow(name, error);
  printRow("all", total_);
  for (const Failure &failure : kept_)
    std::printf("\n%s on %s, class %s\n  %s\n  kernel: %s\n", failure.format.c_str(), failure.device.c_str(),
                failure.className.c_str(), corpusLine(failure.ray).c_str(), hitText(failure.kernel).c_str());
}

void HardRayReport::addTo(Json &figures) const {
  figures["error"] = errorJson(total_);
  figures["classes"] = rowsOf(classes_);
  figures["devices_error"] = rowsOf(devices_);
  figures["failures"] = Json::array();
  for (const Failure &failure : kept_)
    figures["failures"].push_back({{"format", failure.format},
                                   {"device", failure.device},
                                   {"class", failure.className},
                                   {"ray", corpusLine(failure.ray)},
                                   {"kernel", hitText(failure.kernel)}});
}

} // namespace voxc::tool
