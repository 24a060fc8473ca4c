// Numbers that the classes of hard rays are made of.
#include "Points.h"

#include <cmath>
#include <limits>

namespace voxc::test {

float signedPower(RandomSource &random, int low, int high) {
  const float sign = random.sign();
  return std::ldexp(sign, random.integer(low, high));
}

double scaledReal(RandomSource &random, int low, int high) {
  // In two statements: the order of two calls in one expression is the compiler's choice.
  const int exponent = random.integer(low, high);
  return std::ldexp(random.real(0.5, 1), exponent);
}

float nudged(RandomSource &random, float value) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const int way = random.integer(-1, 1);
  return way == 0 ? value : std::nextafter(value, static_cast<float>(way) * kInfinity);
}

} // namespace voxc::test
