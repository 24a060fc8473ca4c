// A ray in exact arithmetic: the moments at which its cell changes, their order, and its cell at each.
#pragma once

#include "voxc/Trace/Ray.h"

#include <cmath>
#include <compare>

namespace voxc {

/// Whether all six components are finite; of other rays nothing is asked but that they miss.
bool isFinite(const Ray &ray);

/// When a ray's cell changes: at the time at which the ray's coordinate on `axis` is `face`, or just after
/// it. Without an axis it is the ray's start. Only moments at t >= 0 are ever made.
struct Moment {
  int axis = -1;
  int face = 0;
  bool after = false; ///< Half-open cells: a rising axis changes cell at the time, a falling one after it.
  double approximate = 0; ///< The time, within a relative error of 2^-51; 0 only if it is 0.
};

/// Six finite float32 taken as exact numbers. Every answer is exact: doubles decide where their error bound
/// permits, pairs of doubles where their operands fit, integers of several hundred bits elsewhere.
class ExactRay {
public:
  explicit ExactRay(const Ray &ray);

  double origin(int axis) const { return origin_[axis]; }
  double direction(int axis) const { return direction_[axis]; }

  /// The moment at which the cell changes at `face`, which the ray passes at t >= 0 along a moving axis.
  Moment crossing(int axis, int face) const {
    // The difference, the reciprocal and the product are rounded once each: 3 * 2^-53 and a little.
    return {axis, face, direction_[axis] < 0, std::abs((face - origin_[axis]) * reciprocal_[axis])};
  }

  /// The order in time; what happens just after a time comes after what happens at it.
  std::weak_ordering compare(const Moment &a, const Moment &b) const {
    if (a.approximate * (1 + kTimeSlack) < b.approximate)
      return std::weak_ordering::less;
    if (b.approximate * (1 + kTimeSlack) < a.approximate)
      return std::weak_ordering::greater;
    return compareExactly(a, b);
  }

  /// Whether the moment's time is before, at or after `t`, a number that is finite and not below 0.
  std::weak_ordering compareTime(const Moment &moment, float t) const;

  /// The ray's cell on one axis once all that happens at `moment` has happened. It must fit an int.
  int cell(int axis, const Moment &moment) const;

  /// The moment's time, rounded to the nearest float32, ties to even; +inf beyond.
  float time(const Moment &moment) const;

private:
  // Two of the times above, and the rounding of the product, differ by less than 8 * 2^-53.
  static constexpr double kTimeSlack = 0x1p-50;

  std::weak_ordering compareExactly(const Moment &a, const Moment &b) const;
  int cellNear(int axis, int face, const Moment &moment) const;

  double origin_[3];
  double direction_[3];
  double reciprocal_[3]; // Of no use on an axis that does not move.
};

} // namespace voxc
