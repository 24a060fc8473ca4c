// The loops over extents, scenes, formats and devices.
#include "hard-rays/HardRaySweep.h"

#include "testing/HardRays.h"
#include "voxc/IR/Query.h"
#include "voxc/Oracle/VerifyRays.h"

#include <algorithm>
#include <array>
#include <bit>
#include <thread>
#include <tuple>

namespace voxc::tool {

namespace {

constexpr std::uint64_t kMostRaysAtOnce = std::uint64_t{1} << 20;
constexpr std::size_t kVoxelsAimedAt = 4096;

bool isBefore(Int3 a, Int3 b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

/// All extents of a list of formats, each once.
std::vector<Int3> extentsOf(const std::vector<Format> &formats) {
  std::vector<Int3> extents;
  extents.reserve(formats.size());
  for (const Format &format : formats)
    extents.push_back(format.extent());
  std::ranges::sort(extents, isBefore);
  const auto repeated = std::ranges::unique(extents);
  extents.erase(repeated.begin(), repeated.end());
  return extents;
}

/// A seed for each of many sets, so that no two of them share their rays.
std::uint64_t mixed(std::uint64_t seed, std::uint64_t salt) {
  std::uint64_t x = seed + 0x9e3779b97f4a7c15 * (salt + 1);
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9;
  x = (x ^ x >> 27) * 0x94d049bb133111eb;
  return x ^ x >> 31;
}

/// To the bit, NaN and signs of zero included.
bool sameHit(const Hit &a, const Hit &b) {
  using Bits = std::array<std::uint32_t, sizeof(Hit) / 4>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

bool holds(const Format &format, Int3 extent) { return contains(format.extent(), extent - Int3{1, 1, 1}); }

Error withFormat(const Format &format, Error error) {
  error.message = toString(format) + ": " + error.message;
  return error;
}

} // namespace

bool HardRaySweep::isOver() const { return size_.seconds > 0 && watch_.seconds() >= size_.seconds; }

/// The formats of an extent that take this scene: each takes so many of them, the next ones in turn.
HardRaySweep::Indices HardRaySweep::formatsOf(std::size_t scene, Int3 extent, std::uint64_t round) const {
  const std::size_t each = size_.scenes == 0 ? names_.size() : std::min(size_.scenes, names_.size());
  Indices indices;
  for (std::size_t format = 0; format < formats_.size(); ++format) {
    const std::size_t first = (format + round) * each % names_.size();
    if (formats_[format].extent() == extent && (scene + names_.size() - first) % names_.size() < each)
      indices.push_back(format);
  }
  return indices;
}

Expected<void> HardRaySweep::run(const SweepSize &size) {
  size_ = size;
  names_ = VOXC_TRY(scenes_.names());
  const std::size_t each = size.scenes == 0 ? names_.size() : std::min(size.scenes, names_.size());
  const std::uint64_t runs = formats_.size() * each * devices_.all().size();
  const std::uint64_t raysEach = std::max<std::uint64_t>(1, (size.rays + runs - 1) / runs);
  const std::uint64_t rounds = (raysEach + kMostRaysAtOnce - 1) / kMostRaysAtOnce;
  for (std::uint64_t round = 0; size.seconds > 0 ? !isOver() : round < rounds; ++round)
    VOXC_TRY(runRound(round, (raysEach + rounds - 1) / rounds));
  return {};
}

Expected<void> HardRaySweep::runRound(std::uint64_t round, std::uint64_t raysEach) {
  for (const Int3 extent : extentsOf(formats_)) {
    for (std::size_t scene = 0; scene < names_.size(); ++scene) {
      const Indices formats = formatsOf(scene, extent, round);
      if (formats.empty() || isOver())
        continue;
      VOXC_TRY(runScene(scene, extent, formats, round, raysEach));
    }
    constructors_.clear(); // None of them is needed for another extent.
  }
  return {};
}

Expected<void> HardRaySweep::runScene(std::size_t scene, Int3 extent, const Indices &formats,
                                      std::uint64_t round, std::uint64_t raysEach) {
  RaySet set{names_[scene], extent, {}, {}, {}, {}};
  const std::uint64_t place =
      mixed(static_cast<std::uint64_t>(extent.x) << 42 | static_cast<std::uint64_t>(extent.y) << 21 |
                static_cast<std::uint64_t>(extent.z),
            scene);
  const auto oracle = VOXC_TRY(makeSet(set, raysEach, mixed(size_.seed + round, place)));
  for (const std::size_t format : formats) {
    if (isOver())
      break;
    VOXC_TRY(traceSet(set, oracle, format));
    if (size_.scenes == 1)
      constructors_.clear(); // Each is asked once: nothing grows with the number of formats.
  }
  return {};
}

/// Fills the set with rays of every class and their exact hits.
Expected<Oracle> HardRaySweep::makeSet(RaySet &set, std::uint64_t raysEach, std::uint64_t seed) {
  auto source = VOXC_TRY(scenes_.open(set.scene, set.extent, quiet_));
  auto oracle = VOXC_TRY(Oracle::of(*source, quiet_));
  const std::vector<Int3> voxels = oracle.sampleVoxels(kVoxelsAimedAt);
  for (const ClassShare &share : budget_.share(set.scene, static_cast<std::size_t>(raysEach))) {
    const std::vector<Ray> rays =
        test::hardRays({source->extent(), voxels}, share.name, share.rays, mixed(seed, set.parts.size()));
    set.parts.push_back({std::string(share.name), set.rays.size(), rays.size()});
    set.rays.insert(set.rays.end(), rays.begin(), rays.end());
  }
  if (size_.bounds)
    for (const BoundedRay &ray : withHardBounds(oracle, set.rays, seed))
      set.bounds.push_back(ray.bounds());
  VOXC_TRY(answer(set, oracle));
  return oracle;
}

Expected<void> HardRaySweep::answer(RaySet &set, const Oracle &oracle) {
  const Stopwatch watch;
  const std::vector<BoundedRay> rays = set.boundedRays();
  set.exact = VOXC_TRY(oracle.trace(rays, devices_.threads(), quiet_));
  times_.oracle += watch.seconds();
  times_.exactRays += set.rays.size();
  return {};
}

Expected<Volume> HardRaySweep::build(const RaySet &set, std::size_t format) {
  const Stopwatch watch;
  auto constructor = constructors_.find(format);
  if (constructor == constructors_.end()) {
    Expected<Constructor> compiled = Constructor::compile(formats_[format]);
    if (!compiled)
      return withFormat(formats_[format], compiled.error());
    constructor = constructors_.emplace(format, std::move(*compiled)).first;
  }
  auto source = VOXC_TRY(scenes_.open(set.scene, set.extent, quiet_));
  BuildOptions options;
  options.threads =
      devices_.threads() > 0 ? devices_.threads() : std::max(std::thread::hardware_concurrency(), 1u);
  options.progress = quiet_;
  Expected<Built> built = constructor->second.build(*source, options);
  if (!built)
    return withFormat(formats_[format], built.error());
  times_.build += watch.seconds();
  return std::move(built->volume);
}

namespace {

/// Gives hits of volumes without colours those of the scene, so that all else of them is compared.
void colourHits(std::span<Hit> hits, const Oracle &oracle) {
  for (Hit &hit : hits)
    if (hit.isHit() && hit.rgba == kOccupied)
      hit.rgba = oracle.voxel({hit.voxel[0], hit.voxel[1], hit.voxel[2]});
}

} // namespace

Expected<void> HardRaySweep::traceSet(const RaySet &set, const Oracle &oracle, std::size_t format) {
  const auto volume = VOXC_TRY(build(set, format));
  Format asked = formats_[format];
  if (set.isBounded())
    askForBounds(asked);
  if (const std::string_view problem = problemOfQuestion(asked); !problem.empty())
    return withFormat(asked, Error::usage("the format " + std::string(problem)));
  const std::vector<BoundedRay> boundedRays = set.isBounded() ? set.boundedRays() : std::vector<BoundedRay>();
  const RaySpan rays = set.isBounded() ? RaySpan(boundedRays) : RaySpan(set.rays);
  std::vector<Hit> hits(rays.size());
  for (const TracingDevices::Device &device : devices_.all()) {
    const Stopwatch watch;
    Json figures;
    VOXC_TRY(device.tracing->prepare(volume, asked, figures));
    times_.kernel += watch.seconds();
    VOXC_TRY(device.tracing->trace(rays, hits, {.progress = quiet_}, figures));
    times_.trace += figures.value("cpu_seconds", 0.0);
    if (const PayloadKind &kind = kindOf(volume.layout().payload); !kind.varies && !kind.oneColour)
      colourHits(hits, oracle);
    report_.add(set, oracle, hits, asked, figures.value("device", device.name));
    const double done = size_.seconds > 0
                            ? watch_.seconds() / size_.seconds
                            : static_cast<double>(report_.rays()) / static_cast<double>(size_.rays);
    progress_.at("hard rays", done, report_.rays());
  }
  return progress_.stopped() ? Expected<void>(Error::interrupted()) : Expected<void>();
}

namespace {

/// The corpus by scene and extent, as sets.
std::vector<RaySet> setsOf(const std::vector<CorpusRay> &corpus) {
  std::vector<RaySet> sets;
  for (const CorpusRay &ray : corpus) {
    auto set = std::ranges::find_if(sets, [&](const RaySet &other) {
      return other.scene == ray.scene && other.extent == ray.extent &&
             other.isBounded() == ray.bounds.has_value();
    });
    if (set == sets.end())
      set = sets.insert(sets.end(), {ray.scene, ray.extent, {}, {}, {}, {{"corpus", 0, 0}}});
    set->rays.push_back(ray.ray);
    if (ray.bounds)
      set->bounds.push_back(*ray.bounds);
    set->exact.push_back(ray.exact);
    ++set->parts[0].count;
  }
  return sets;
}

Error wrongInCorpus(const RaySet &set, std::size_t index, const Hit &exact) {
  return Error::input("the corpus has " + corpusLine(corpusRay(set, index)) + ", but the oracle's hit is " +
                      hitText(exact));
}

} // namespace

Expected<void> HardRaySweep::runCorpus(const std::vector<CorpusRay> &corpus) {
  for (RaySet &set : setsOf(corpus)) {
    auto source = VOXC_TRY(scenes_.open(set.scene, set.extent, quiet_));
    const auto oracle = VOXC_TRY(Oracle::of(*source, quiet_));
    for (std::size_t i = 0; i < set.rays.size(); ++i)
      if (const Hit exact = oracle.trace(set.rays[i], set.isBounded() ? set.bounds[i] : RayBounds{});
          !sameHit(exact, set.exact[i]))
        return wrongInCorpus(set, i, exact);
    size_.rays += set.rays.size() * formats_.size() * devices_.all().size();
    for (std::size_t format = 0; format < formats_.size(); ++format)
      if (holds(formats_[format], set.extent))
        VOXC_TRY(traceSet(set, oracle, format));
  }
  if (report_.rays() == 0 && !corpus.empty())
    return Error::input("no format is large enough for a ray of the corpus");
  return {};
}

} // namespace voxc::tool
