// Findings as tables and as JSON.
#include "accuracy/Findings.h"

#include "tracing/ErrorCheck.h"
#include "tracing/TraceSession.h"

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>

namespace voxc::tool {
namespace {

/// The first candidate's time over this one's.
double ratioTo(const VariantCandidate &first, const VariantCandidate &candidate) {
  const double seconds = measure::median(candidate.times.cpuSeconds);
  return seconds > 0 ? measure::median(first.times.cpuSeconds) / seconds : 0;
}

void printVariants(const Findings &findings) {
  std::printf("%-28s %7s %6s %6s %8s %9s %9s %8s %11s %7s %7s\n", "variant", "missed", "ghost", "wrong",
              "boundary", "max_dt", "rms_dt", "max_ulp", "Mrays/CPU s", "spread", "ratio");
  const std::vector<std::string> names = labels(findings);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const VariantCandidate &candidate = *findings.candidates[i];
    const ErrorFigures &error = candidate.error;
    const bool equal =
        measure::areEqual(findings.candidates[0]->times.cpuSeconds, candidate.times.cpuSeconds);
    std::printf("%-28s %7" PRIu64 " %6" PRIu64 " %6" PRIu64 " %8" PRIu64
                " %9.3g %9.3g %8.3g %11.4g %6.1f%% %6.3f%s\n",
                names[i].c_str(), error.missed, error.ghost, error.wrong, error.boundary, error.maxDt,
                error.rmsDt, error.maxUlpDt, mraysPerCpuSecond(candidate),
                100 * measure::spread(candidate.times.cpuSeconds),
                ratioTo(*findings.candidates[0], candidate), equal ? " =" : "");
  }
  std::printf(
      "errors on %" PRIu64
      " of %zu rays; speeds are medians of %u rounds in turn; = as fast as the first within the spread\n",
      findings.candidates[0]->error.rays, findings.candidates[0]->subject.hits().size(), findings.rounds);
}

void printLods(const std::vector<LodFinding> &lods) {
  std::printf("\n%-8s %11s %9s %9s %6s %9s\n", "lod", "Mrays/CPU s", "speed-up", "psnr", "worst", "changed");
  for (const LodFinding &lod : lods)
    std::printf("%-8g %11.4g %8.3f%s %6.2f dB %6d %8.2f%%\n", lod.pixels, lod.mraysPerCpuSecond, lod.speedUp,
                lod.equal ? "=" : " ", lod.picture.psnr, lod.picture.worst, 100 * lod.picture.changed);
}

void printSeries(const char *name, const std::vector<SeriesPoint> &series,
                 const std::vector<std::string> &names) {
  std::printf("\n%-12s", name);
  for (const std::string &label : names)
    std::printf(" %28s", label.c_str());
  std::printf("\n%-12s", "voxels");
  for (std::size_t i = 0; i < names.size(); ++i)
    std::printf(" %15s %12s", "errors/million", "Mrays/CPU s");
  for (const SeriesPoint &point : series) {
    std::printf("\n%-12g", point.at);
    for (const Score &score : point.scores)
      std::printf(" %15.4g %12.4g", errorsPerMillion(score.error), score.mraysPerCpuSecond);
  }
  std::printf("\n");
}

/// min, median, max and spread; null of none.
Json repeatsJson(const measure::Repeats &repeats) {
  if (repeats.empty())
    return nullptr;
  return {{"min", std::ranges::min(repeats)},
          {"median", measure::median(repeats)},
          {"max", std::ranges::max(repeats)},
          {"spread", measure::spread(repeats)}};
}

Json variantJson(const VariantCandidate &candidate, const VariantCandidate &first, const std::string &label) {
  Json json{{"label", label}, {"precision", candidate.variant.precision}};
  if (!candidate.variant.traversal.empty())
    json["traversal"] = candidate.variant.traversal;
  addSetupFigures(json, candidate.subject.opened());
  json["device"] = candidate.subject.deviceInfo().name;
  json["first_dispatch_seconds"] = candidate.subject.firstDispatchSeconds();
  json["error"] = errorJson(candidate.error);
  json["cpu_seconds"] = repeatsJson(candidate.times.cpuSeconds);
  json["seconds"] = repeatsJson(candidate.times.seconds);
  if (!candidate.times.deviceSeconds.empty())
    json["device_seconds"] = repeatsJson(candidate.times.deviceSeconds);
  json["mrays_per_cpu_s"] = mraysPerCpuSecond(candidate);
  json["ratio"] = ratioTo(first, candidate);
  json["equal"] = measure::areEqual(first.times.cpuSeconds, candidate.times.cpuSeconds);
  return json;
}

Json lodJson(const LodFinding &lod) {
  return {{"pixels", lod.pixels},
          {"mrays_per_cpu_s", lod.mraysPerCpuSecond},
          {"speed_up", lod.speedUp},
          {"equal", lod.equal},
          {"psnr", std::isfinite(lod.picture.psnr) ? Json(lod.picture.psnr) : Json(nullptr)},
          {"worst", lod.picture.worst},
          {"changed", lod.picture.changed}};
}

Json seriesJson(const std::vector<SeriesPoint> &series) {
  Json points = Json::array();
  for (const SeriesPoint &point : series) {
    Json scores = Json::array();
    for (const Score &score : point.scores)
      scores.push_back({{"mrays_per_cpu_s", score.mraysPerCpuSecond}, {"error", errorJson(score.error)}});
    points.push_back({{"voxels", point.at}, {"variants", std::move(scores)}});
  }
  return points;
}

} // namespace

std::vector<std::string> labels(const Findings &findings) {
  bool severalDevices = false;
  for (const auto &candidate : findings.candidates)
    severalDevices |= candidate->variant.device != findings.candidates[0]->variant.device;
  std::vector<std::string> names;
  names.reserve(findings.candidates.size());
  for (const auto &candidate : findings.candidates)
    names.push_back(candidate->variant.label(severalDevices));
  return names;
}

void printTables(const Findings &findings) {
  printVariants(findings);
  if (!findings.lods.empty())
    printLods(findings.lods);
  if (!findings.distances.empty())
    printSeries("distance", findings.distances, labels(findings));
  if (!findings.resolutions.empty())
    printSeries("resolution", findings.resolutions, labels(findings));
}

void addFindings(Json &figures, const Findings &findings) {
  const std::vector<std::string> names = labels(findings);
  figures["rounds"] = findings.rounds;
  figures["variants"] = Json::array();
  for (std::size_t i = 0; i < names.size(); ++i)
    figures["variants"].push_back(variantJson(*findings.candidates[i], *findings.candidates[0], names[i]));
  for (const LodFinding &lod : findings.lods)
    figures["lods"].push_back(lodJson(lod));
  if (!findings.distances.empty())
    figures["series"]["distance"] = seriesJson(findings.distances);
  if (!findings.resolutions.empty())
    figures["series"]["resolution"] = seriesJson(findings.resolutions);
}

} // namespace voxc::tool
