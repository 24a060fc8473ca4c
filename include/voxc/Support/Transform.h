// Affine maps of points: from voxels to the units of the model that they come from.
#pragma once

#include <glm/mat4x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>

namespace voxc {

/// Three rows, and four columns of which the last is the translation. By default it moves nothing, where
/// GLM's own matrices have no value at all.
struct Transform : glm::dmat4x3 {
  constexpr Transform() : glm::dmat4x3(1.0) {}
  constexpr Transform(const glm::dmat4x3 &matrix) : glm::dmat4x3(matrix) {}
  constexpr Transform(const glm::dvec3 &x, const glm::dvec3 &y, const glm::dvec3 &z, const glm::dvec3 &origin)
      : glm::dmat4x3(x, y, z, origin) {}
  /// The last row of the matrix is left out.
  explicit constexpr Transform(const glm::dmat4 &matrix) : glm::dmat4x3(matrix) {}
};

/// The entries row by row, as files hold them.
std::array<double, 12> rowsOf(const Transform &transform);
Transform transformOfRows(const std::array<double, 12> &rows);

/// True if no entry is infinite or no number.
bool isFinite(const Transform &transform);

} // namespace voxc
