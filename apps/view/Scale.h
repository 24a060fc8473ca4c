// Scales of charts: how values become places, and which of them have a tick.
#pragma once

#include <string>
#include <vector>

namespace voxc::view {

struct Tick {
  double place;
  std::string text;
};

/// An axis from `begin` to `end`, with all values on it and about so many ticks at most.
class Scale {
public:
  /// From 0, with ticks at round steps.
  static Scale linear(const std::vector<double> &values, double begin, double end, int maxTicks);
  /// Logarithmic, with ticks at powers of 2 that are told as sizes of memory. Precondition: the values are
  /// positive, and there is one.
  static Scale bytes(const std::vector<double> &values, double begin, double end, int maxTicks);

  double place(double value) const;
  const std::vector<Tick> &ticks() const { return ticks_; }

private:
  Scale(bool isLogarithmic, double low, double high, double begin, double end)
      : isLogarithmic_(isLogarithmic), low_(low), high_(high), begin_(begin), end_(end) {}

  bool isLogarithmic_;
  double low_, high_; ///< Of a logarithmic scale, logarithms.
  double begin_, end_;
  std::vector<Tick> ticks_;
};

} // namespace voxc::view
