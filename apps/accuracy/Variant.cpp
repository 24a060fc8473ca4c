// Variants traced in turn.
#include "accuracy/Variant.h"
#include "voxc/IR/Query.h"

#include <algorithm>

namespace voxc::tool {
namespace {

bool hasTrees(const Format &format) {
  return std::ranges::any_of(format.levels, [](const Level &level) { return level.kind->isTree(); });
}

Variant makeVariant(const Format &format, const std::string &precision, const std::string &walk,
                    const std::string &device) {
  Variant variant{precision, walk, device, 0, format};
  askForPrecision(variant.format, precision);
  if (!walk.empty())
    for (Level &level : variant.format.levels)
      level.setAttribute(kWalkAttribute, walk);
  return variant;
}

} // namespace

std::vector<std::string> walksOfTrees() {
  return {kWalkAttribute.values.begin(), kWalkAttribute.values.end()};
}

std::string Variant::label(bool severalDevices) const {
  std::string text = precision;
  if (!walk.empty())
    text += " " + walk;
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
  const std::vector<std::string> walks = hasTrees(format) ? choice.walks : std::vector<std::string>{""};
  std::vector<Variant> variants;
  for (const std::string &device : choice.devices)
    for (const std::string &precision : choice.precisions)
      for (const std::string &walk : walks)
        variants.push_back(makeVariant(format, precision, walk, device));
  return variants;
}

Variant withLod(const Variant &variant, double pixels) {
  Variant coarse = variant;
  coarse.lod = pixels;
  askForCones(coarse.format, pixels > 0);
  return coarse;
}

Expected<std::unique_ptr<Contestant>> prepare(const Variant &variant, const Volume &volume, unsigned threads,
                                              const std::string &order) {
  auto contestant = std::make_unique<Contestant>();
  contestant->variant = variant;
  contestant->tracing.choose(variant.device, threads);
  contestant->tracing.chooseOrder(order);
  if (Expected<void> opened = contestant->tracing.openDevice({.quiet = true}); !opened)
    return opened.error();
  if (Expected<void> prepared = contestant->tracing.prepare(volume, variant.format, contestant->setup);
      !prepared)
    return prepared.error();
  return contestant;
}

Expected<void> traceOnce(Contestant &contestant, std::span<const Ray> rays, bool counted,
                         const Progress &progress) {
  Json figures;
  contestant.hits.resize(rays.size());
  const TraceOptions options{.spread = contestant.spread, .progress = progress.silent()};
  if (Expected<void> traced = contestant.tracing.trace(rays, contestant.hits, options, figures); !traced)
    return traced;
  contestant.order = figures["order"];
  if (!counted) {
    contestant.setup["device"] = figures["device"];
    contestant.firstDispatchSeconds = figures["first_dispatch_seconds"];
    return {};
  }
  contestant.cpuSeconds.push_back(figures["cpu_seconds"]);
  contestant.seconds.push_back(figures["seconds"]);
  if (figures.contains("device_seconds"))
    contestant.deviceSeconds.push_back(figures["device_seconds"]);
  return {};
}

Expected<void> traceInTurn(std::span<const std::unique_ptr<Contestant>> contestants,
                           std::span<const Ray> rays, unsigned rounds, const Progress &progress) {
  for (const auto &contestant : contestants) {
    contestant->cpuSeconds.clear();
    contestant->seconds.clear();
    contestant->deviceSeconds.clear();
  }
  for (unsigned round = 0; round <= rounds; ++round)
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      const double done = static_cast<double>(round * contestants.size() + i);
      progress.at("trace", done / static_cast<double>((rounds + 1) * contestants.size()), 0);
      if (progress.stopped())
        return Error::interrupted();
      if (Expected<void> traced = traceOnce(*contestants[i], rays, round > 0, progress); !traced)
        return traced;
    }
  return {};
}

void check(std::span<const std::unique_ptr<Contestant>> contestants, const Oracle &oracle,
           std::span<const Ray> rays, std::size_t sample) {
  const std::size_t count = std::min(sample, rays.size());
  std::vector<Ray> sampledRays(count);
  std::vector<Hit> sampledHits(count);
  for (const auto &contestant : contestants) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = i * rays.size() / count;
      sampledRays[i] = rays[at];
      sampledHits[i] = contestant->hits[at];
    }
    contestant->error = compare(oracle, sampledRays, sampledHits);
  }
}

double mraysPerCpuSecond(const Contestant &contestant) {
  const double seconds = median(contestant.cpuSeconds);
  return seconds > 0 ? static_cast<double>(contestant.hits.size()) / seconds * 1e-6 : 0;
}

double errorsPerMillion(const ErrorFigures &error) {
  return error.rays == 0 ? 0
                         : 1e6 * static_cast<double>(error.missed + error.ghost + error.wrong) /
                               static_cast<double>(error.rays);
}

} // namespace voxc::tool
