// The matrices of instances.
#include "InstancePlaces.h"

#include <glm/matrix.hpp>

#include <cmath>
#include <string>

namespace voxc {
namespace {

bool isFinite(const glm::dmat4 &matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(matrix[column][row]))
        return false;
  return true;
}

bool isAffine(const glm::dmat4 &matrix) {
  return matrix[0][3] == 0 && matrix[1][3] == 0 && matrix[2][3] == 0 && matrix[3][3] == 1;
}

} // namespace

Error wrongInstance(std::size_t number, const char *problem) {
  return Error::usage("instance " + std::to_string(number) + " " + problem);
}

Expected<glm::dmat4> fromWorldOf(const glm::mat4 &toWorld, std::size_t number) {
  const glm::dmat4 matrix(toWorld);
  if (!isFinite(matrix) || !isAffine(matrix))
    return wrongInstance(
        number, "has a matrix that is not affine: its last row must be 0, 0, 0, 1, and all of it finite");
  const glm::dmat4 inverse = glm::inverse(matrix);
  if (!isFinite(inverse))
    return wrongInstance(number, "has a matrix without an inverse");
  return inverse;
}

} // namespace voxc
