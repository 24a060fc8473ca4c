// A ray in exact arithmetic: double filters with proven bounds, and wide integers behind them.
#include "ExactRay.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

namespace voxc {

namespace {

namespace mp = boost::multiprecision;

// Every finite float32 is a multiple of 2^-149 below 2^128: an integer below 2^277 once scaled. The widest
// numbers here are products of two of those with a few bits to spare.
using Integer = mp::number<mp::cpp_int_backend<640, 640, mp::signed_magnitude, mp::unchecked, void>>;
constexpr int kScale = 149;

// A time is a difference and a quotient of doubles that hold their operands exactly and can neither overflow
// nor underflow: two roundings, less than 2^-51 relative. The filters leave room for their own roundings.
constexpr double kTimeSlack = 0x1p-50;
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

/// The cell of a coordinate known to within `error`, unless an integer is so near that it could be two.
std::optional<int> certainCell(double coordinate, double error) {
  const double cell = std::floor(coordinate - error);
  if (coordinate - error > cell && coordinate + error < cell + 1)
    return static_cast<int>(cell);
  return std::nullopt;
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

Moment ExactRay::crossing(int axis, int face) const {
  return {axis, face, direction(axis) < 0, std::abs((face - origin(axis)) / direction(axis))};
}

std::weak_ordering ExactRay::compare(const Moment &a, const Moment &b) const {
  if (a.approximate * (1 + kTimeSlack) < b.approximate)
    return std::weak_ordering::less;
  if (b.approximate * (1 + kTimeSlack) < a.approximate)
    return std::weak_ordering::greater;
  if (a.axis != b.axis || a.face != b.face) {
    const Fraction timeA = exactTime(*this, a), timeB = exactTime(*this, b);
    const int order =
        Integer(timeA.numerator * timeB.denominator).compare(timeB.numerator * timeA.denominator);
    if (order != 0)
      return order <=> 0;
  }
  return a.after <=> b.after;
}

int ExactRay::cell(int axis, const Moment &moment) const {
  if (moment.axis == axis)
    return moment.after ? moment.face - 1 : moment.face;
  if (moment.axis < 0 || direction(axis) == 0)
    return static_cast<int>(std::floor(origin(axis)));

  const double travelled = moment.approximate * direction(axis);
  const double error = (std::abs(origin(axis)) + std::abs(travelled)) * kPositionSlack;
  if (const std::optional<int> cell = certainCell(origin(axis) + travelled, error))
    return *cell;

  const Fraction time = exactTime(*this, moment);
  const Integer coordinate =
      scaled(origin(axis)) * time.denominator + scaled(direction(axis)) * time.numerator;
  return exactCell(coordinate, time.denominator << kScale, moment.after && direction(axis) < 0);
}

float ExactRay::time(const Moment &moment) const {
  // Rounding is monotonic: if both bounds round to the same float32, so does the time between them.
  const auto below = static_cast<float>(moment.approximate * (1 - kTimeSlack));
  const auto above = static_cast<float>(moment.approximate * (1 + kTimeSlack));
  return below == above ? below : nearer(exactTime(*this, moment), below, above);
}

} // namespace voxc
