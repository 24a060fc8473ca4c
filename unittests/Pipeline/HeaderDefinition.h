// Hits between two moments as they are defined, by rational arithmetic: what functions of generated headers
// must find.
#pragma once

#include "Oracle/BruteForce.h"
#include "testing/RandomFormat.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Trace/Ray.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <ostream>
#include <random>
#include <utility>
#include <vector>

namespace voxc {

/// What is asked: a ray, and the moments between which it is looked at. Two records of a kernel's rays.
struct HeaderQuery {
  Ray ray;
  float tmin, tmax;
  float unused[4] = {};
};

/// A hit as headers have it.
struct HeaderHit {
  std::int32_t voxel[3] = {-1, -1, -1};
  float t = 0;
  std::uint32_t colour = 0;
  std::int32_t axis = -1, side = 0;

  bool operator==(const HeaderHit &other) const { return std::memcmp(this, &other, sizeof *this) == 0; }
};

inline std::ostream &operator<<(std::ostream &stream, const HeaderHit &hit) {
  return stream << '(' << hit.voxel[0] << ", " << hit.voxel[1] << ", " << hit.voxel[2]
                << ") t=" << std::hexfloat << hit.t << std::hex << " colour=" << hit.colour << std::dec
                << " axis=" << hit.axis << " side=" << hit.side;
}

/// A voxel on a ray, and when that enters it.
struct Entry {
  test::End moment;
  HeaderHit hit;
};

/// The cells on a ray, axis by axis, so that few are looked at.
inline std::vector<std::pair<test::End, Int3>> cellsOf(Int3 extent, const Ray &ray) {
  std::vector<std::pair<test::End, Int3>> cells;
  const auto within = [&](const test::Interval &times, int axis, int cell) {
    const auto own = test::timesIn(ray.origin[axis], ray.direction[axis], cell);
    return own ? test::intersection(times, *own) : test::Interval{{test::Rational(1)}, {test::Rational(0)}};
  };
  for (int x = 0; x < extent.x; ++x)
    if (const auto inX = within({}, 0, x); !isEmpty(inX))
      for (int y = 0; y < extent.y; ++y)
        if (const auto inY = within(inX, 1, y); !isEmpty(inY))
          for (int z = 0; z < extent.z; ++z)
            if (const auto times = within(inY, 2, z); !isEmpty(times))
              cells.emplace_back(times.low, Int3{x, y, z});
  std::ranges::sort(cells, test::startsSooner, &std::pair<test::End, Int3>::first);
  return cells;
}

/// All voxels on a ray, in order.
inline std::vector<Entry> entriesOf(const Oracle &oracle, Int3 extent, const Ray &ray) {
  std::vector<Entry> entries;
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(ray.origin[axis]) || !std::isfinite(ray.direction[axis]))
      return entries;
  for (const auto &[moment, cell] : cellsOf(extent, ray)) {
    const std::uint32_t word = oracle.voxel(cell);
    const Face face = word != 0 ? test::bruteForceFace(ray, cell) : Face{};
    if (word != 0)
      entries.push_back(
          {moment, {{cell.x, cell.y, cell.z}, test::roundToFloat(*moment.t), word, face.axis, face.side}});
  }
  return entries;
}

/// Those between the moments, by the definition.
inline std::vector<HeaderHit> expectedHits(const std::vector<Entry> &entries, const HeaderQuery &query) {
  std::vector<HeaderHit> hits;
  if (std::isnan(query.tmin) || std::isnan(query.tmax))
    return hits;
  const auto isBefore = [](const Entry &entry, float t) {
    return t == std::numeric_limits<float>::infinity() ||
           (std::isfinite(t) && *entry.moment.t < test::Rational(t));
  };
  const auto isAfter = [](const Entry &entry, float t) {
    return t == -std::numeric_limits<float>::infinity() ||
           (std::isfinite(t) && *entry.moment.t > test::Rational(t));
  };
  for (const Entry &entry : entries)
    if (!isBefore(entry, query.tmin) && !isAfter(entry, query.tmax))
      hits.push_back(entry.hit);
  return hits;
}

/// Moments that hurt: those of entries and their neighbours, and what is no moment.
inline float randomMoment(std::mt19937 &random, const std::vector<Entry> &entries) {
  constexpr float kOdd[] = {0.0f,
                            -0.0f,
                            -1.0f,
                            1e-40f,
                            1e-30f,
                            3e38f,
                            std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity(),
                            std::numeric_limits<float>::quiet_NaN()};
  const int kind = test::pick(random, 0, 7);
  if (kind == 0)
    return kOdd[test::pick(random, 0, 8)];
  if (kind == 1 || entries.empty())
    return static_cast<float>(test::pick(random, 0, 4000)) / 100.0f;
  const float t = entries[test::pick(random, 0, static_cast<int>(entries.size()) - 1)].hit.t;
  return kind < 5 ? t : std::nextafter(t, kind < 7 ? 1e38f : 0.0f);
}

inline HeaderQuery randomQuery(std::mt19937 &random, const Ray &ray, const std::vector<Entry> &entries) {
  const int kind = test::pick(random, 0, 3);
  const float infinity = std::numeric_limits<float>::infinity();
  return {ray, kind < 2 ? 0.0f : randomMoment(random, entries),
          kind % 2 == 0 ? infinity : randomMoment(random, entries)};
}

} // namespace voxc
