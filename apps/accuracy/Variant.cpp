// Variants traced in turn.
#include "accuracy/Variant.h"
#include "voxc/IR/Query.h"

#include <algorithm>

namespace voxc::tool {
namespace {

bool hasTrees(const Format &format) {
  return std::ranges::any_of(format.levels, [](const Level &level) { return level.kind->isTree(); });
}

Variant makeVariant(const Format &format, const std::string &precision, const std::string &traversal,
                    const std::string &device) {
  Variant variant{precision, traversal, device, 0, format};
  askForPrecision(variant.format, precision);
  if (!traversal.empty())
    for (Level &level : variant.format.levels)
      level.setAttribute(kTraversalAttribute, traversal);
  return variant;
}

} // namespace

std::vector<std::string> traversalsOfTrees() {
  return {kTraversalAttribute.values.begin(), kTraversalAttribute.values.end()};
}

std::string Variant::label(bool severalDevices) const {
  std::string text = precision;
  if (!traversal.empty())
    text += " " + traversal;
  if (severalDevices && !device.empty())
    text += " " + device;
  if (lod > 0) {
    std::string pixels = std::to_string(lod);
    pixels.erase(pixels.find_last_not_of('0') + 1);
    text += " lod " + (pixels.ends_with('.') ? pixels.substr(0, pixels.size() - 1) : pixels);
  }
  return text;
}

std::vector<Variant> makeVariants(const Format &format, const VariantChoice &choice) {
  const std::vector<std::string> traversals =
      hasTrees(format) ? choice.traversals : std::vector<std::string>{""};
  std::vector<Variant> variants;
  for (const std::string &device : choice.devices)
    for (const std::string &precision : choice.precisions)
      for (const std::string &traversal : traversals)
        variants.push_back(makeVariant(format, precision, traversal, device));
  return variants;
}

Variant withLod(const Variant &variant, double pixels) {
  Variant coarse = variant;
  coarse.lod = pixels;
  askForCones(coarse.format, pixels > 0);
  return coarse;
}

Expected<std::unique_ptr<VariantCandidate>> prepare(const Variant &variant, const Volume &volume,
                                                    unsigned threads, const std::string &order) {
  auto candidate = std::make_unique<VariantCandidate>();
  candidate->variant = variant;
  candidate->tracing.choose(variant.device, threads);
  candidate->tracing.chooseOrder(order);
  if (Expected<void> opened = candidate->tracing.openDevice({.quiet = true}); !opened)
    return opened.error();
  if (Expected<void> prepared = candidate->tracing.prepare(volume, variant.format, candidate->setup);
      !prepared)
    return prepared.error();
  return candidate;
}

Expected<void> traceOnce(VariantCandidate &candidate, std::span<const Ray> rays, bool counted,
                         const Progress &progress) {
  Json figures;
  candidate.hits.resize(rays.size());
  const TraceOptions options{.spread = candidate.spread, .progress = progress.silent()};
  if (Expected<void> traced = candidate.tracing.trace(rays, candidate.hits, options, figures); !traced)
    return traced;
  candidate.order = figures["order"];
  if (!counted) {
    candidate.setup["device"] = figures["device"];
    candidate.firstDispatchSeconds = figures["first_dispatch_seconds"];
    return {};
  }
  candidate.cpuSeconds.push_back(figures["cpu_seconds"]);
  candidate.seconds.push_back(figures["seconds"]);
  if (figures.contains("device_seconds"))
    candidate.deviceSeconds.push_back(figures["device_seconds"]);
  return {};
}

Expected<void> traceInTurn(std::span<const std::unique_ptr<VariantCandidate>> candidates,
                           std::span<const Ray> rays, unsigned rounds, const Progress &progress) {
  for (const auto &candidate : candidates) {
    candidate->cpuSeconds.clear();
    candidate->seconds.clear();
    candidate->deviceSeconds.clear();
  }
  for (unsigned round = 0; round <= rounds; ++round)
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const double done = static_cast<double>(round * candidates.size() + i);
      progress.at("trace", done / static_cast<double>((rounds + 1) * candidates.size()), 0);
      if (progress.stopped())
        return Error::interrupted();
      if (Expected<void> traced = traceOnce(*candidates[i], rays, round > 0, progress); !traced)
        return traced;
    }
  return {};
}

void check(std::span<const std::unique_ptr<VariantCandidate>> candidates, const Oracle &oracle,
           std::span<const Ray> rays, std::size_t sample) {
  const std::size_t count = std::min(sample, rays.size());
  std::vector<Ray> sampledRays(count);
  std::vector<Hit> sampledHits(count);
  for (const auto &candidate : candidates) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = i * rays.size() / count;
      sampledRays[i] = rays[at];
      sampledHits[i] = candidate->hits[at];
    }
    candidate->error = compare(oracle, sampledRays, sampledHits);
  }
}

double mraysPerCpuSecond(const VariantCandidate &candidate) {
  const double seconds = median(candidate.cpuSeconds);
  return seconds > 0 ? static_cast<double>(candidate.hits.size()) / seconds * 1e-6 : 0;
}

double errorsPerMillion(const ErrorFigures &error) {
  return error.rays == 0 ? 0
                         : 1e6 * static_cast<double>(error.missed + error.ghost + error.wrong) /
                               static_cast<double>(error.rays);
}

} // namespace voxc::tool
