// Where instances stand in the world.
#include "InstanceBoxes.h"

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace voxc {
namespace {

/// Rays are not held to a matrix by which lengths are rounded so many times as much.
constexpr double kMostCondition = 1 << 16;

/// What a product of two matrices of 4x4 loses by rounding, of the product of their magnitudes.
constexpr double kProductRounding = 8 * std::numeric_limits<double>::epsilon();

glm::dmat4 magnitudeOf(const glm::dmat4 &matrix) {
  return {glm::abs(matrix[0]), glm::abs(matrix[1]), glm::abs(matrix[2]), glm::abs(matrix[3])};
}

/// The largest sum of a row's magnitudes, of the part that turns and scales.
double normOf(const glm::dmat4 &matrix) {
  const glm::dmat3 m(magnitudeOf(matrix));
  const glm::dvec3 sums = m[0] + m[1] + m[2];
  return std::max({sums.x, sums.y, sums.z});
}

/// At least the norm of Euclid, and not more where the matrix turns and scales along axes, in whatever order:
/// its square is no more than the largest row sum of the matrix by its transpose, on either side.
double euclideanNormOf(const glm::dmat4 &matrix) {
  const glm::dmat3 m(matrix), t = glm::transpose(m);
  const double least = std::min(normOf(glm::dmat4(t * m)), normOf(glm::dmat4(m * t)));
  return std::sqrt(least) * (1 + 0x1p-40);
}

double largestOf(const glm::dvec3 &v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// How far a point of the world whose largest coordinate is 1 may be, and the world's origin is, from where
/// `toWorld` brings back what `fromWorld` makes of it.
struct Residual {
  double ofPoint;
  double ofOrigin;
};

Residual residualOf(const glm::dmat4 &toWorld, const glm::dmat4 &fromWorld) {
  const glm::dmat4 rounding = magnitudeOf(toWorld) * magnitudeOf(fromWorld) * kProductRounding;
  const glm::dmat4 difference = magnitudeOf(toWorld * fromWorld - glm::dmat4(1)) + rounding;
  return {normOf(difference), largestOf(glm::dvec3(difference[3]))};
}

glm::vec3 roundedDown(const glm::dvec3 &v) {
  const auto down = [](double x) {
    return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity());
  };
  return {down(v.x), down(v.y), down(v.z)};
}

bool isFinite(const glm::vec3 &v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

} // namespace

InstanceBox boxOf(const glm::dmat4 &toWorld, const glm::dmat4 &fromWorld, Int3 extent) {
  glm::dvec3 low(toWorld[3]), high(toWorld[3]);
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 edge = glm::dvec3(toWorld[axis]) * static_cast<double>(extent[axis]);
    low += glm::min(edge, glm::dvec3(0));
    high += glm::max(edge, glm::dvec3(0));
  }
  // Where x = T v + R x, R being the residual, x is at most 2 (|R| |T v| + |R of the origin|) from T v.
  const Residual residual = residualOf(toWorld, fromWorld);
  const double reach = std::max(largestOf(low), largestOf(high));
  const double room = 2 * (residual.ofPoint * reach + residual.ofOrigin);
  InstanceBox box;
  box.low = roundedDown(low - room);
  box.high = -roundedDown(-(high + room));
  // The inverse of F is (1 - R)^-1 T, whose norm is at most this; sqrt(3) R is R's by Euclid, or more.
  const double norm = euclideanNormOf(toWorld) / (1 - 1.75 * residual.ofPoint);
  const double condition = norm * euclideanNormOf(fromWorld);
  box.slack = static_cast<float>(2.25 * condition / (1 << 24));
  // There the largest component is at least 2^-121, of which half the least denormal number, 2^-150, is less
  // than u / 32.
  box.leastDirection = static_cast<float>(normOf(toWorld) * 0x1p-120);
  const bool isHeld = residual.ofPoint < 0.25 && condition < kMostCondition; // False for NaN too.
  box.isEverywhere = !isHeld || !isFinite(box.low) || !isFinite(box.high);
  return box;
}

} // namespace voxc
