// The definition of a hit once more, with neither traversal nor filter: every voxel's own interval of t, as
// rationals.
#pragma once

#include "voxc/Oracle/Oracle.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Trace/BoundedRay.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
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

/// All t >= 0 at which a ray's cell is `cell`, if there are any.
inline std::optional<Interval> timesIn(const Ray &ray, Int3 cell) {
  Interval times;
  for (int axis = 0; axis < 3; ++axis) {
    const auto own = timesIn(ray.origin[axis], ray.direction[axis], cell[axis]);
    if (!own)
      return std::nullopt;
    times = intersection(times, *own);
  }
  return isEmpty(times) ? std::nullopt : std::optional(times);
}

/// Every cell of an extent that a finite ray has, in order.
inline std::vector<Int3> bruteForceCells(Int3 extent, const Ray &ray) {
  std::vector<std::pair<End, Int3>> found;
  for (Int3 cell; cell.z < extent.z; ++cell.z)
    for (cell.y = 0; cell.y < extent.y; ++cell.y)
      for (cell.x = 0; cell.x < extent.x; ++cell.x)
        if (const auto times = timesIn(ray, cell))
          found.emplace_back(times->low, cell);
  std::ranges::sort(found, startsSooner, &std::pair<End, Int3>::first);
  std::vector<Int3> cells;
  for (const auto &[start, cell] : found)
    cells.push_back(cell);
  return cells;
}

/// The face by which a finite ray enters a cell that it has: of the first axis whose own interval begins when
/// the ray's time in the cell does.
inline Face bruteForceFace(const Ray &ray, Int3 cell) {
  const End low = timesIn(ray, cell)->low;
  if (*low.t == 0 && low.closed)
    return {};
  for (int axis = 0; axis < 3; ++axis) {
    const End own = timesIn(ray.origin[axis], ray.direction[axis], cell[axis])->low;
    if (*own.t == *low.t && own.closed == low.closed)
      return {axis, ray.direction[axis] > 0 ? -1 : 1};
  }
  return {};
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

/// Whether a moment lies between bounds.
inline bool isWithin(const Rational &t, const RayBounds &bounds) {
  if (std::isnan(bounds.tmin) || std::isnan(bounds.tmax))
    return false;
  const bool isLateEnough = std::isinf(bounds.tmin) ? bounds.tmin < 0 : t >= Rational(bounds.tmin);
  const bool isSoonEnough = std::isinf(bounds.tmax) ? bounds.tmax > 0 : t <= Rational(bounds.tmax);
  return isLateEnough && isSoonEnough;
}

/// The hit of a ray on a list of voxels, of those that it enters between the bounds.
inline Hit bruteForce(const std::vector<Voxel> &voxels, const Ray &ray, const RayBounds &bounds = {}) {
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
    if (isEmpty(times) || !isWithin(*times.low.t, bounds) || (first && !startsSooner(times.low, *first)))
      continue;
    first = times.low;
    hit = {{voxel.cell.x, voxel.cell.y, voxel.cell.z}, voxel.word, 0, 0};
  }
  if (first)
    hit.t = roundToFloat(*first->t);
  return hit;
}

} // namespace voxc::test
