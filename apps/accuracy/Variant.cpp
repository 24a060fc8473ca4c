// Variants traced in turn.
#include "accuracy/Variant.h"
#include "voxc/IR/Query.h"
#include "voxc/Trace/SampleIndex.h"

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
                                                    measure::Devices &devices, unsigned threads,
                                                    float spread) {
  const auto device = VOXC_TRY(devices.open(variant.device));
  auto subject = VOXC_TRY(measure::Subject::open(volume, variant.format,
                                                 {.device = device, .threads = threads, .spread = spread}));
  return std::make_unique<VariantCandidate>(VariantCandidate{variant, std::move(subject), {}, {}});
}

Expected<void> traceInTurn(std::span<const std::unique_ptr<VariantCandidate>> candidates,
                           std::span<const Ray> rays, unsigned rounds, const Progress &progress) {
  for (const auto &candidate : candidates)
    candidate->times = {};
  for (unsigned round = 0; round <= rounds; ++round)
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const double done = static_cast<double>(round * candidates.size() + i);
      progress.at("trace", done / static_cast<double>((rounds + 1) * candidates.size()), 0);
      VOXC_TRY(progress.check());
      measure::Times *const times = round > 0 ? &candidates[i]->times : nullptr;
      VOXC_TRY(candidates[i]->subject.trace(rays, times, progress));
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
      const std::size_t at = sampleIndex(i, count, rays.size());
      sampledRays[i] = rays[at];
      sampledHits[i] = candidate->subject.hits()[at];
    }
    candidate->error = compare(oracle, sampledRays, sampledHits);
  }
}

double mraysPerCpuSecond(const VariantCandidate &candidate) {
  const double seconds = measure::median(candidate.times.cpuSeconds);
  return seconds > 0 ? static_cast<double>(candidate.subject.hits().size()) / seconds * 1e-6 : 0;
}

double errorsPerMillion(const ErrorFigures &error) {
  return error.rays == 0 ? 0
                         : 1e6 * static_cast<double>(error.missed + error.ghost + error.wrong) /
                               static_cast<double>(error.rays);
}

} // namespace voxc::tool
