// The light of pictures: a sun, a sky that is brighter above than below, and what a ray to it brings.
#pragma once

#include "voxc/Trace/Ray.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace voxc {

/// What a white surface that faces the sun sends back of it, linear.
inline constexpr glm::vec3 kSunLight = {1.20f, 1.11f, 0.96f};

/// What a white surface of this direction sends back of a sky that nothing hides, linear.
glm::vec3 skyLight(const glm::vec3 &normal);

/// The colour of the sky behind things in a direction, linear.
glm::vec3 backdrop(const glm::vec3 &direction);

/// A direction about a normal for two numbers in [0, 1): evenly spread numbers make directions that lie as
/// dense as the light from there counts (by the cosine).
glm::vec3 skyDirection(const glm::vec3 &normal, const glm::vec2 &numbers);

/// Two numbers in [0, 1), the i-th of an evenly spread sequence (additive recurrence by the plastic number).
glm::vec2 evenNumbers(std::uint32_t i);

/// The share of the sky's light that a ray towards it brings: all if it meets nothing, else what surfaces
/// pass on, which is the less the nearer they are. `scale` is a distance in voxels where that is half of it.
float openness(const Hit &hit, float scale);

} // namespace voxc
