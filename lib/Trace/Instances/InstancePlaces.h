// The matrices of instances: which are taken, and their inverses.
#pragma once

#include "voxc/Support/Error.h"

#include <glm/mat4x4.hpp>

#include <cstddef>

namespace voxc {

/// From the world to the voxels of instance `number`. Errors (`Usage`): `toWorld` is not finite, has another
/// last row than 0, 0, 0, 1, or has no inverse in float64.
Expected<glm::dmat4> fromWorldOf(const glm::mat4 &toWorld, std::size_t number);

/// Says what is wrong with an instance.
Error wrongInstance(std::size_t number, const char *problem);

} // namespace voxc
