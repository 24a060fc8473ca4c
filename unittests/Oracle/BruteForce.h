// The definition of a hit once more, with neither walk nor filter: every voxel's own interval of t, as
// rationals.
#pragma once

#include "voxc/Support/Geometry.h"
#include "voxc/Trace/Ray.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace voxc::test {

using Rational = boost::multiprecision::cpp_rational;

struct Voxel {
  Int3 cell;
  std::uint32_t word;
};

/// An end of an interval of t: a value that belongs to it or not. Without a value it is infinite.
struct End {
  std::optional<Rational> t;
  bool closed = true;
};

struct Interval {
  End low{Rational(0)};
  End high{};
};

/// True if an interval that starts at `a` starts sooner than one that starts at `b`.
inline bool startsSooner(const End &a, const End &b) {
  return *a.t < *b.t || (*a.t == *b.t && a.closed && !b.closed);
}

/// True if an interval that ends at `a` ends sooner than one that ends at `b`.
inline bool endsSooner(const End &a, const End &b) {
  return a.t && (!b.t || *a.t < *b.t || (*a.t == *b.t && !a.closed && b.closed));
}

inline bool isEmpty(const Interval &interval) {
  const End &low = interval.low, &high = interval.high;
  return high.t && (*high.t < *low.t || (*high.t == *low.t && !(low.closed && high.closed)));
}

inline Interval intersection(const Interval &a, const Interval &b) {
  return {startsSooner(a.low, b.low) ? b.low : a.low, endsSooner(a.high, b.high) ? a.high : b.high};
}

/// All t >= 0 at which floor(origin + t * direction) is `cell`, if there are any.
inline std::optional<Interval> timesIn(float origin, float direction, int cell) {
  const Rational o(origin), d(direction);
  Interval times;
  if (d == 0)
    return o >= cell && o < cell + 1 ? std::optional(times) : std::nullopt;
  const End atLow{(Rational(cell) - o) / d, true}, atHigh{(Rational(cell + 1) - o) / d, false};
  times = intersection(times, d > 0 ? Interval{atLow, atHigh} : Interval{atHigh, atLow});
  return isEmpty(times) ? std::nullopt : std::optional(times);
}

/// The float32 nearest to t >= 0, by halving the range of their bit patterns; ties to the even pattern.
inline float roundToFloat(const Rational &t) {
  const auto value = [](std::uint32_t bits) {
    return bits == 0x7f800000 ? Rational(std::ldexp(1.0, 128)) : Rational(std::bit_cast<float>(bits));
  };
  std::uint32_t low = 0, high = 0x7f800000;
  while (high - low > 1) {
    const std::uint32_t middle = low + (high - low) / 2;
    (value(middle) <= t ? low : high) = middle;
  }
  const Rational middle = (value(low) + value(high)) / 2;
  const bool down = t < middle || (t == middle && low % 2 == 0);
  return std::bit_cast<float>(down ? low : high);
}

/// The hit of a ray on a list of voxels.
inline Hit bruteForce(const std::vector<Voxel> &voxels, const Ray &ray) {
  Hit hit{{-1, -1, -1}, 0, 0, 0};
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(ray.origin[axis]) || !std::isfinite(ray.direction[axis]))
      return hit;
  std::map<int, std::optional<Interval>> known[3]; // By cell, each computed once.
  std::optional<End> first;
  for (const Voxel &voxel : voxels) {
    Interval times;
    for (int axis = 0; axis < 3 && !isEmpty(times); ++axis) {
      auto [cached, isNew] = known[axis].try_emplace(voxel.cell[axis]);
      if (isNew)
        cached->second = timesIn(ray.origin[axis], ray.direction[axis], voxel.cell[axis]);
      times = cached->second ? intersection(times, *cached->second) : Interval{{Rational(1)}, {Rational(0)}};
    }
    if (isEmpty(times) || (first && !startsSooner(times.low, *first)))
      continue;
    first = times.low;
    hit = {{voxel.cell.x, voxel.cell.y, voxel.cell.z}, voxel.word, 0, 0};
  }
  if (first)
    hit.t = roundToFloat(*first->t);
  return hit;
}

} // namespace voxc::test
