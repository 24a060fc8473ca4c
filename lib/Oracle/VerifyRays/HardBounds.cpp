// Bounds of rays that are chosen to hurt.
#include "voxc/Oracle/VerifyRays.h"

#include "RandomSource.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voxc {
namespace {

using oracle::RandomSource;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// So many voxels of a ray are looked for.
constexpr int kMostEntries = 6;

/// Whatever is no moment, or hardly one.
constexpr float kOdd[] = {0.0f,
                          -0.0f,
                          -1.0f,
                          std::numeric_limits<float>::denorm_min(),
                          1e-40f,
                          1e-30f,
                          3e38f,
                          std::numeric_limits<float>::max(),
                          kInfinity,
                          -kInfinity,
                          std::numeric_limits<float>::quiet_NaN()};

/// When the ray enters voxels, each moment once, in order.
std::vector<float> entriesOf(const Oracle &oracle, const Ray &ray) {
  std::vector<float> entries;
  RayBounds rest;
  while (entries.size() < kMostEntries) {
    const Hit hit = oracle.trace(ray, rest);
    if (!hit.isHit())
      break;
    entries.push_back(hit.t);
    if (std::isinf(hit.t))
      break;
    rest.tmin = std::nextafter(std::max(hit.t, rest.tmin), kInfinity);
  }
  return entries;
}

/// A moment at an entry, beside one, between two of them, or an odd one.
float hardMoment(RandomSource &random, std::span<const float> entries) {
  const int kind = random.integer(0, 9);
  if (kind == 0)
    return kOdd[random.integer(0, static_cast<int>(std::size(kOdd)) - 1)];
  if (entries.empty())
    return static_cast<float>(random.real(0, 100));
  const float t = entries[random.integer(0, static_cast<int>(entries.size()) - 1)];
  if (kind < 5)
    return t;
  if (kind < 8)
    return std::nextafter(t, kind < 7 ? kInfinity : 0.0f);
  return static_cast<float>(t * random.real(0, 1.5));
}

} // namespace

std::vector<BoundedRay> withHardBounds(const Oracle &oracle, std::span<const Ray> rays, std::uint64_t seed) {
  RandomSource random(seed);
  std::vector<BoundedRay> result;
  result.reserve(rays.size());
  for (const Ray &ray : rays) {
    const std::vector<float> entries = entriesOf(oracle, ray);
    RayBounds bounds;
    if (random.integer(0, 3) != 0)
      bounds.tmin = hardMoment(random, entries);
    if (random.flip())
      bounds.tmax = hardMoment(random, entries);
    result.push_back(bounded(ray, bounds));
  }
  return result;
}

} // namespace voxc
