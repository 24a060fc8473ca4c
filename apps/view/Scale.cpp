// Scales: linear from 0, or by powers of 2.
#include "view/Scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace voxc::view {
namespace {

/// A multiple of a round step, which has few digits.
std::string numberText(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

/// "512 KiB" for 2^19.
std::string powerText(int exponent) {
  static constexpr std::array<const char *, 7> kUnits = {"B", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
  const int unit = std::clamp(exponent / 10, 0, static_cast<int>(kUnits.size()) - 1);
  return numberText(std::exp2(exponent - 10 * unit)) + " " + kUnits[static_cast<std::size_t>(unit)];
}

/// The least of 1, 2 and 5 times a power of 10 that is not below `value`.
double roundStep(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= value * (1 - 1e-9))
      return factor * power;
  return 10 * power;
}

} // namespace

Scale Scale::linear(const std::vector<double> &values, double begin, double end, int maxTicks) {
  const double most = values.empty() ? 0 : std::ranges::max(values);
  const double high = most > 0 ? most * 1.05 : 1;
  const double step = roundStep(high / maxTicks);
  const int count = static_cast<int>(std::ceil(high / step));
  Scale scale(false, 0, step * count, begin, end);
  for (int i = 0; i <= count; ++i)
    scale.ticks_.push_back({scale.place(step * i), numberText(step * i)});
  return scale;
}

Scale Scale::bytes(const std::vector<double> &values, double begin, double end, int maxTicks) {
  constexpr double kRounding = 1e-9;
  const auto [least, most] = std::ranges::minmax(values);
  const double low = std::floor(std::log2(least) + kRounding);
  const double high = std::max(std::ceil(std::log2(most) - kRounding), low + 1);
  Scale scale(true, low, high, begin, end);
  const int step = std::max(1, static_cast<int>(std::ceil((high - low) / maxTicks)));
  for (int exponent = static_cast<int>(low); exponent <= static_cast<int>(high); exponent += step)
    scale.ticks_.push_back({scale.place(std::exp2(exponent)), powerText(exponent)});
  return scale;
}

double Scale::place(double value) const {
  const double on = isLogarithmic_ ? std::log2(value) : value;
  return begin_ + (on - low_) / (high_ - low_) * (end_ - begin_);
}

} // namespace voxc::view
