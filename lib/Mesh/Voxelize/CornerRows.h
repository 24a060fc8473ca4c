// Rows of numbers at the corners of a triangle.
#pragma once

#include "Mesh/ModelFrame.h"

#include <array>
#include <cstddef>

namespace voxc {

/// The sum of three corners' rows by their weights.
template <std::size_t N>
std::array<double, N> mixed(const std::array<std::array<double, N>, 3> &rows, const glm::dvec3 &weights) {
  std::array<double, N> sum{};
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (std::size_t i = 0; i < N; ++i)
      sum[i] += weights[corner] * rows[corner][i];
  return sum;
}

} // namespace voxc
