// A ray in exact arithmetic: the moments at which its cell changes, their order, and its cell at each.
#pragma once

#include "voxc/Trace/Ray.h"

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
/// permits, integers of several hundred bits elsewhere.
class ExactRay {
public:
  explicit ExactRay(const Ray &ray) : ray_(ray) {}

  double origin(int axis) const { return ray_.origin[axis]; }
  double direction(int axis) const { return ray_.direction[axis]; }

  /// The moment at which the cell changes at `face`, which the ray passes at t >= 0 along a moving axis.
  Moment crossing(int axis, int face) const;

  /// The order in time; what happens just after a time comes after what happens at it.
  std::weak_ordering compare(const Moment &a, const Moment &b) const;

  /// The ray's cell on one axis once all that happens at `moment` has happened. It must fit an int.
  int cell(int axis, const Moment &moment) const;

  /// The moment's time, rounded to the nearest float32, ties to even; +inf beyond.
  float time(const Moment &moment) const;

private:
  Ray ray_;
};

} // namespace voxc
