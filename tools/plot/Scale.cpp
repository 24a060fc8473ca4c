// Scales: linear from 0, or by powers.
#include "plot/Scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace voxc::plot {
namespace {

/// How much of a logarithmic axis is given to 0.
constexpr double kZeroShare = 0.12;

std::string superscript(int number) {
  static constexpr std::array<const char *, 10> kDigits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = number < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(number)))
    text += kDigits[static_cast<std::size_t>(digit - '0')];
  return text;
}

std::string powerText(double base, int exponent) {
  if (base == 10 && exponent >= -2 && exponent <= 2)
    return shortNumber(std::pow(base, exponent));
  return shortNumber(base) + superscript(exponent);
}

/// "512 KiB" for 2^19.
std::string bytesText(int exponent) {
  static constexpr std::array<const char *, 7> kUnits = {"B", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
  const int unit = std::clamp(exponent / 10, 0, static_cast<int>(kUnits.size()) - 1);
  return shortNumber(std::pow(2, exponent - 10 * unit)) + " " + kUnits[static_cast<std::size_t>(unit)];
}

/// A multiple of a round step, which has few digits.
std::string roundNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
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

std::string shortNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

Scale::Scale(const Axis &axis, const std::vector<double> &values, double begin, double end, int maxTicks)
    : begin_(begin), end_(end) {
  if (axis.spacing == Spacing::Linear)
    fitLinear(values, maxTicks);
  else
    fitPowers(axis, values, maxTicks);
}

void Scale::fitLinear(const std::vector<double> &values, int maxTicks) {
  const double most = values.empty() ? 0 : std::ranges::max(values);
  const double step = roundStep((most > 0 ? most * 1.05 : 1) / maxTicks);
  const int count = static_cast<int>(std::ceil((most > 0 ? most * 1.05 : 1) / step));
  high_ = step * count;
  for (int i = 0; i <= count; ++i)
    ticks_.push_back({place(step * i), roundNumber(step * i)});
}

void Scale::fitPowers(const Axis &axis, const std::vector<double> &values, int maxTicks) {
  base_ = axis.spacing == Spacing::Decades ? 10 : 2;
  zero_ = axis.least > 0 || std::ranges::any_of(values, [](double value) { return value <= 0; });
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const double value : values)
    if (value > 0) {
      least = std::min(least, value);
      most = std::max(most, value);
    }
  if (axis.least > 0)
    least = std::min(least, axis.least);
  if (std::isinf(least))
    least = 1;
  most = std::max(most, least);
  constexpr double kRounding = 1e-9;
  low_ = std::floor(std::log(least) / std::log(base_) + kRounding);
  high_ = std::max(std::ceil(std::log(most) / std::log(base_) - kRounding), low_ + 1);
  if (zero_)
    ticks_.push_back({place(0), "0"});
  const int step = std::max(1, static_cast<int>(std::ceil((high_ - low_) / maxTicks)));
  for (int exponent = static_cast<int>(low_); exponent <= static_cast<int>(high_); exponent += step)
    ticks_.push_back({place(std::pow(base_, exponent)),
                      axis.spacing == Spacing::Bytes ? bytesText(exponent) : powerText(base_, exponent)});
}

double Scale::place(double value) const {
  if (base_ == 0)
    return begin_ + (value - low_) / (high_ - low_) * (end_ - begin_);
  const double first = zero_ ? begin_ + kZeroShare * (end_ - begin_) : begin_;
  if (value <= 0)
    return begin_;
  return first + (std::log(value) / std::log(base_) - low_) / (high_ - low_) * (end_ - first);
}

double Scale::breakPlace() const {
  return zero_ ? begin_ + kZeroShare / 2 * (end_ - begin_) : std::numeric_limits<double>::infinity();
}

} // namespace voxc::plot
