// A ray in exact arithmetic: double filters with proven bounds, pairs of doubles, and wide integers behind
// them.
#include "ExactRay.h"

#include "DoublePair.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>

namespace voxc {

namespace {

namespace mp = boost::multiprecision;

// Every finite float32 is a multiple of 2^-149 below 2^128: an integer below 2^277 once scaled. The widest
// numbers here are products of two of those with a few bits to spare.
using Integer = mp::number<mp::cpp_int_backend<640, 640, mp::signed_magnitude, mp::unchecked, void>>;
constexpr int kScale = 149;

// A coordinate is an approximate time, at most 3 roundings, times a direction, and a sum: 6 of 2^-53 at most
// with the rounding of a test. Doubles hold the operands exactly and neither overflow nor underflow.
constexpr double kPositionSlack = 0x1p-50;

/// A time as a fraction; the denominator is positive.
struct Fraction {
  Integer numerator;
  Integer denominator;
};

/// `value` times 2^149, or times 2^(149 + more).
Integer scaled(double value, int more = 0) { return Integer(std::ldexp(value, kScale + more)); }

Fraction exactTime(const ExactRay &ray, const Moment &moment) {
  if (moment.axis < 0)
    return {0, 1};
  const Integer distance = scaled(moment.face) - scaled(ray.origin(moment.axis));
  const Integer speed = scaled(ray.direction(moment.axis));
  return {abs(distance), abs(speed)};
}

/// The cell of coordinate numerator / denominator: that below it, if `open`, where it is an integer.
int exactCell(const Integer &numerator, const Integer &denominator, bool open) {
  Integer quotient, remainder;
  divide_qr(numerator, denominator, quotient, remainder);
  const bool below = remainder.is_zero() ? open : numerator < 0;
  return static_cast<int>(quotient) - (below ? 1 : 0);
}

/// `value` rounded down; unlike the standard library's, in line on every machine.
int floorToInt(double value) {
  const int towardsZero = static_cast<int>(value);
  return towardsZero - (towardsZero > value ? 1 : 0);
}

/// Distance times speed of the other axis; the order of two times is that of two of these. Nothing, if a
/// difference is not exact in double.
std::optional<DoublePair> crossProduct(const ExactRay &ray, const Moment &moment, const Moment &other) {
  const std::optional<double> distance = exactDifference(moment.face, ray.origin(moment.axis));
  if (!distance)
    return std::nullopt;
  return exactProduct(std::abs(*distance), std::abs(ray.direction(other.axis)));
}

/// The order of two times by wide integers alone.
int compareWide(const ExactRay &ray, const Moment &a, const Moment &b) {
  const Fraction timeA = exactTime(ray, a), timeB = exactTime(ray, b);
  return Integer(timeA.numerator * timeB.denominator).compare(timeB.numerator * timeA.denominator);
}

/// Which of two neighbouring float32 is nearer to `time`.
float nearer(const Fraction &time, float below, float above) {
  const double top = std::isinf(above) ? 0x1p128 : double{above};
  const double middle = 0.5 * (double{below} + top);
  const Integer left = time.numerator << (kScale + 1);
  const Integer right = scaled(middle, 1) * time.denominator;
  if (left == right)
    return std::bit_cast<std::uint32_t>(below) % 2 == 0 ? below : above;
  return left < right ? below : above;
}

} // namespace

bool isFinite(const Ray &ray) {
  const auto finite = [](float component) { return std::isfinite(component); };
  return std::ranges::all_of(ray.origin, finite) && std::ranges::all_of(ray.direction, finite);
}

ExactRay::ExactRay(const Ray &ray) {
  for (int axis = 0; axis < 3; ++axis) {
    origin_[axis] = ray.origin[axis];
    direction_[axis] = ray.direction[axis];
    reciprocal_[axis] = 1 / direction_[axis];
  }
}

std::weak_ordering ExactRay::compareExactly(const Moment &a, const Moment &b) const {
  const bool same = a.axis == b.axis && a.face == b.face;
  // The start, and a face that holds the origin, are at 0, and nothing else is.
  if (same || (a.approximate == 0 && b.approximate == 0))
    return a.after <=> b.after;
  if (a.axis < 0 || b.axis < 0)
    return a.approximate < b.approximate ? std::weak_ordering::less : std::weak_ordering::greater;
  const std::optional<DoublePair> left = crossProduct(*this, a, b), right = crossProduct(*this, b, a);
  const int found = left && right ? order(*left, *right) : compareWide(*this, a, b);
  return found != 0 ? found <=> 0 : a.after <=> b.after;
}

std::weak_ordering ExactRay::compareTime(const Moment &moment, float t) const {
  if (moment.approximate * (1 + kTimeSlack) < t)
    return std::weak_ordering::less;
  if (t < moment.approximate * (1 - kTimeSlack))
    return std::weak_ordering::greater;
  const Fraction time = exactTime(*this, moment);
  return Integer(time.numerator << kScale).compare(scaled(t) * time.denominator) <=> 0;
}

/// The cell on `axis` at a moment at which no boundary but `face` can be within the error of a double.
int ExactRay::cellNear(int axis, int face, const Moment &moment) const {
  const bool falls = direction_[axis] < 0;
  const bool behind = falls ? face > origin_[axis] : face < origin_[axis];
  const bool passed = behind || compare(crossing(axis, face), moment) <= 0;
  return passed == falls ? face - 1 : face;
}

int ExactRay::cell(int axis, const Moment &moment) const {
  if (moment.axis == axis)
    return moment.after ? moment.face - 1 : moment.face;
  if (moment.axis < 0 || direction_[axis] == 0)
    return floorToInt(origin_[axis]);

  const double travelled = moment.approximate * direction_[axis];
  const double error = (std::abs(origin_[axis]) + std::abs(travelled)) * kPositionSlack;
  const double coordinate = origin_[axis] + travelled;
  if (error < 0.25) {
    const int low = floorToInt(coordinate - error), high = floorToInt(coordinate + error);
    const bool touches = low == coordinate - error;
    return low == high && !touches ? low : cellNear(axis, touches ? low : high, moment);
  }
  const Fraction time = exactTime(*this, moment);
  const Integer exact = scaled(origin_[axis]) * time.denominator + scaled(direction_[axis]) * time.numerator;
  return exactCell(exact, time.denominator << kScale, moment.after && direction_[axis] < 0);
}

float ExactRay::time(const Moment &moment) const {
  // Rounding is monotonic: if both bounds round to the same float32, so does the time between them.
  const auto below = static_cast<float>(moment.approximate * (1 - kTimeSlack));
  const auto above = static_cast<float>(moment.approximate * (1 + kTimeSlack));
  return below == above ? below : nearer(exactTime(*this, moment), below, above);
}

} // namespace voxc
