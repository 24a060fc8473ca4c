// Affine maps of points: from voxels to the units of the model that they come from.
#pragma once

#include <glm/mat4x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>

namespace voxc {

/// Three rows, and four columns of which the last is the translation. A `glm::dmat4` converts to it, and so
/// does a `glm::mat4`.
using Transform = glm::dmat4x3;

/// The map that moves nothing.
inline constexpr Transform kNoTransform = Transform(1.0);

/// The entries row by row, as files hold them.
std::array<double, 12> rowsOf(const Transform &transform);
Transform transformOfRows(const std::array<double, 12> &rows);

/// True if no entry is infinite or no number.
bool isFinite(const Transform &transform);

} // namespace voxc
