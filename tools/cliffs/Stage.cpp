// Building places, and rays with bounds.
#include "Stage.h"

#include "RayKinds.h"
#include "Scenes.h"

#include "testing/HardRays/RandomSource.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Support/Geometry.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace voxc::cliffs {
namespace {

/// 256 MiB: more is slow to build, and tells nothing of rays.
constexpr std::uint64_t kMostWords = std::uint64_t{1} << 26;
constexpr std::size_t kVoxelsAimedAt = 4096;

int log2EdgeOf(const Format &format) {
  const Int3 extent = format.extent();
  return std::bit_width(static_cast<unsigned>(std::max({extent.x, extent.y, extent.z}) - 1));
}

double lengthOf(const Ray &ray) {
  return std::hypot(double{ray.direction[0]}, double{ray.direction[1]}, double{ray.direction[2]});
}

/// The interval of one ray, by where it is in the box and by its hit.
RayBounds boundsOf(Interval interval, const Ray &ray, const Hit &hit, Int3 extent,
                   test::RandomSource &random) {
  if (interval == Interval::All)
    return {};
  if (interval == Interval::Nothing)
    return {1, 0.5f};
  const Passage passage = passageOf(ray, extent);
  if (passage.isEmpty())
    return {0, 1};
  const double end = hit.isHit() ? double{hit.t} : passage.to;
  const double voxel = 1 / std::max(lengthOf(ray), 1e-300);
  double from = passage.from, to = end;
  if (interval == Interval::Short)
    to = from + random.real(1, 8) * voxel;
  else if (interval == Interval::Late)
    from = std::max(from, end - random.real(0.5, 8) * voxel), to = HUGE_VAL;
  else
    from = random.real(from, std::max(from, end)), to = from + random.real(1, 8) * voxel;
  return {static_cast<float>(from), static_cast<float>(to)};
}

/// Moves an origin by at most a 64th of a voxel, or what is 2^-20 of its distance, and turns a direction by a
/// thousandth.
void moveOff(Ray &ray, test::RandomSource &random) {
  for (int axis = 0; axis < 3; ++axis) {
    const double far = std::ldexp(std::abs(double{ray.origin[axis]}), -20);
    ray.origin[axis] += static_cast<float>(random.real(0.5, 1) * std::max(1.0 / 64, far));
    ray.direction[axis] *= static_cast<float>(1 + random.real(-0.001, 0.001));
  }
}

} // namespace

Passage passageOf(const Ray &ray, Int3 extent) {
  Passage passage{0, HUGE_VAL};
  for (int axis = 0; axis < 3; ++axis) {
    const double from = ray.origin[axis], step = ray.direction[axis], size = extent[axis];
    if (step == 0 && (from < 0 || from > size))
      return {};
    if (step == 0)
      continue;
    const double low = -from / step, high = (size - from) / step;
    passage.from = std::max(passage.from, std::min(low, high));
    passage.to = std::min(passage.to, std::max(low, high));
  }
  return passage;
}

Expected<std::optional<Stage>> Stage::build(const Place &place) {
  auto source = openScene(place.scene, place.extent);
  if (!source)
    return source.error();
  auto oracle = VOXC_TRY(Oracle::of(**source));
  source = openScene(place.scene, place.extent);
  auto shape = VOXC_TRY(SceneDag::build(**source, {.log2Side = log2EdgeOf(place.format)}));
  const auto constructor = VOXC_TRY(Constructor::compile(storageFormat(place.format)));
  source = openScene(place.scene, place.extent);
  auto built = constructor.build(**source, {.maxWords = kMostWords});
  if (!built && built.error().kind == ErrorKind::Input)
    return std::optional<Stage>();
  if (!built)
    return built.error();
  std::vector<Int3> voxels = oracle.sampleVoxels(kVoxelsAimedAt);
  return std::optional<Stage>(
      Stage{place, std::move(oracle), std::move(shape), std::move(built->volume), std::move(voxels)});
}

StagedRays raysOf(const Stage &stage, const Situation &situation) {
  StagedRays rays;
  const RayScene scene{stage.oracle, stage.place.extent, stage.voxels};
  rays.plain = makeRays(situation.rays, scene, situation.count, situation.seed);
  // A world of instances is as many times larger as it has instances along an axis.
  if (situation.instances > 0)
    for (Ray &ray : rays.plain)
      for (float &coordinate : ray.origin)
        coordinate *= std::ceil(std::cbrt(static_cast<float>(situation.instances)));
  if (situation.interval == Interval::None)
    return rays;
  test::RandomSource random(situation.seed + 1);
  const bool needsHits = situation.interval == Interval::Late || situation.interval == Interval::Slice;
  rays.bounded.reserve(rays.plain.size());
  for (const Ray &ray : rays.plain) {
    const Hit hit = needsHits ? stage.oracle.trace(ray) : Hit{{-1, -1, -1}, 0, 0, 0};
    rays.bounded.push_back(bounded(ray, boundsOf(situation.interval, ray, hit, stage.place.extent, random)));
  }
  return rays;
}

StagedRays movedOff(const StagedRays &rays) {
  StagedRays moved = rays;
  test::RandomSource random(moved.plain.size());
  for (std::size_t i = 0; i < moved.plain.size(); ++i) {
    moveOff(moved.plain[i], random);
    if (!moved.bounded.empty())
      moved.bounded[i] = bounded(moved.plain[i], {rays.bounded[i].tmin, rays.bounded[i].tmax});
  }
  return moved;
}

} // namespace voxc::cliffs
