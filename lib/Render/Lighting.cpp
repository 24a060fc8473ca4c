// The light of pictures.
#include "Lighting.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace voxc {

namespace {

constexpr glm::vec3 kFromAbove = {0.36f, 0.41f, 0.49f};
constexpr glm::vec3 kFromBelow = {0.17f, 0.155f, 0.14f};

constexpr glm::vec3 kZenith = {0.20f, 0.29f, 0.42f};
constexpr glm::vec3 kHorizon = {0.52f, 0.58f, 0.64f};
constexpr glm::vec3 kGround = {0.26f, 0.27f, 0.29f};

/// What distant surfaces pass on of the sky's light.
constexpr float kPassedOn = 0.5f;

glm::vec3 blend(const glm::vec3 &a, const glm::vec3 &b, float amount) { return a + (b - a) * amount; }

} // namespace

glm::vec3 skyLight(const glm::vec3 &normal) { return blend(kFromBelow, kFromAbove, 0.5f + 0.5f * normal.y); }

glm::vec3 backdrop(const glm::vec3 &direction) {
  const float length = glm::length(direction);
  const float height = length > 0 ? direction.y / length : 0;
  const float amount = std::min(std::abs(height) * 1.3f, 1.0f);
  return blend(kHorizon, height < 0 ? kGround : kZenith, amount * amount * (3 - 2 * amount));
}

glm::vec3 skyDirection(const glm::vec3 &normal, const glm::vec2 &numbers) {
  // A point of a disc around the normal, lifted to the half sphere above it.
  constexpr float kTurn = 6.2831853f;
  const float radius = std::sqrt(numbers.x);
  const float angle = kTurn * numbers.y;
  const glm::vec3 spare = std::abs(normal.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 right = glm::normalize(glm::cross(spare, normal));
  const glm::vec3 front = glm::cross(normal, right);
  return right * (radius * std::cos(angle)) + front * (radius * std::sin(angle)) +
         normal * std::sqrt(std::max(1 - numbers.x, 1e-4f));
}

glm::vec2 evenNumbers(std::uint32_t i) {
  constexpr double kPlastic = 1.32471795724474602596;
  const double x = 0.5 + i / kPlastic;
  const double y = 0.5 + i / (kPlastic * kPlastic);
  return {float(x - std::floor(x)), float(y - std::floor(y))};
}

float openness(const Hit &hit, float scale) {
  return hit.isHit() ? kPassedOn * hit.t / (hit.t + scale) : 1.0f;
}

} // namespace voxc
