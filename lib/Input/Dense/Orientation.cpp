// Axes by what they mean.
#include "Input/Dense/Orientation.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace voxc {

namespace {

using Order = std::array<int, 3>;

/// The cosines between a stored axis and those of the model; all 0 for an axis of no length.
glm::dvec3 directionOf(const Transform &map, int axis) {
  const glm::dvec3 step(map[axis]);
  const double length = glm::length(step);
  return length > 0 && std::isfinite(length) ? step / length : glm::dvec3(0);
}

/// Which stored axis becomes each axis of the voxels: of all orders the one that turns least.
Order nearestOrder(const Transform &map) {
  Order order{0, 1, 2};
  Order best = order;
  double most = -1;
  do {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis)
      sum += std::abs(directionOf(map, order[static_cast<std::size_t>(axis)])[axis]);
    // Axes that lie as near one way as another stay as they are stored.
    if (sum > most + 1e-9) {
      most = sum;
      best = order;
    }
  } while (std::ranges::next_permutation(order).found);
  return best;
}

} // namespace

void orient(DenseVolume &volume, bool mirrorsX) {
  const Transform stored = volume.sampleToModel;
  if (!isFinite(stored) || std::abs(glm::dot(glm::cross(glm::dvec3(stored[0]), glm::dvec3(stored[1])),
                                             glm::dvec3(stored[2]))) == 0)
    return;
  const Order order = nearestOrder(stored);
  const std::array<std::int64_t, 3> given = volume.steps;
  const std::array<std::int64_t, 3> steps = stepsOf(volume);
  const Int3 extent = volume.extent;
  bool isChanged = false;
  for (int axis = 0; axis < 3; ++axis) {
    const int from = order[static_cast<std::size_t>(axis)];
    const std::int64_t step = steps[static_cast<std::size_t>(from)];
    volume.extent[axis] = extent[from];
    const bool isMirrored = (stored[from][axis] < 0) != (mirrorsX && axis == 0);
    volume.steps[static_cast<std::size_t>(axis)] = isMirrored ? -step : step;
    volume.sampleToModel[axis] = isMirrored ? -stored[from] : stored[from];
    if (isMirrored) {
      volume.samples += step * (extent[from] - 1);
      volume.sampleToModel[3] += stored[from] * static_cast<double>(extent[from]);
    }
    isChanged |= isMirrored || from != axis;
  }
  // As they lie they are read fastest.
  if (!isChanged)
    volume.steps = given;
}

} // namespace voxc
