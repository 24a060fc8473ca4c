// From values to places along an axis, and the ticks there.
#pragma once

#include "plot/Plot.h"

#include <string>
#include <vector>

namespace voxc::plot {

struct Tick {
  double place;
  std::string text;
};

class Scale {
public:
  /// A scale for `values` between the places `begin` and `end`, with at most about `maxTicks` ticks.
  Scale(const Axis &axis, const std::vector<double> &values, double begin, double end, int maxTicks);

  double place(double value) const;
  const std::vector<Tick> &ticks() const { return ticks_; }
  /// Where the axis is broken between 0 and its first power; not finite if it is not.
  double breakPlace() const;

private:
  void fitLinear(const std::vector<double> &values, int maxTicks);
  void fitPowers(const Axis &axis, const std::vector<double> &values, int maxTicks);

  double begin_;
  double end_;
  double base_ = 0; ///< 0: linear.
  double low_ = 0;  ///< The value, or its logarithm, at the first place that is not that of 0.
  double high_ = 1;
  bool zero_ = false; ///< 0 has a place before `low_`.
  std::vector<Tick> ticks_;
};

/// A number as short as it can be told at three digits.
std::string shortNumber(double value);

} // namespace voxc::plot
