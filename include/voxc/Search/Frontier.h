// The frontier of sizes and speeds, as an area: what lies below it is beaten.
#pragma once

#include <vector>

namespace voxc {

struct SizeTime {
  double bytes = 0;
  double nanoseconds = 0; ///< A ray.
};

/// What points reach together: for each size the fastest that is no larger. Its area is the hypervolume of
/// multi-objective optimisation, over log2 of bytes and million rays a second, up to a largest size and from
/// a least speed on.
class Frontier {
public:
  explicit Frontier(double mostBytes, double leastSpeed = 0)
      : mostBytes_(mostBytes), leastSpeed_(leastSpeed) {}

  void add(const SizeTime &point);

  /// In octaves of bytes times million rays a second.
  double area() const;
  /// By how much the area would grow with a point.
  double gain(const SizeTime &point) const;
  /// The speed, in million rays a second, of the fastest that has at most so many bytes; 0 without one.
  double speedAt(double bytes) const;

private:
  /// A stair: from its size on, its speed.
  struct Stair {
    double octave; ///< log2 of the bytes.
    double speed;
  };

  Stair stairOf(const SizeTime &point) const;

  double mostBytes_;
  double leastSpeed_;
  std::vector<Stair> stairs_; ///< Of rising size and speed.
};

} // namespace voxc
