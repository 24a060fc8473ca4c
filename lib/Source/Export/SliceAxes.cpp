// How slices lie in a volume.
#include "Source/Export/SliceAxes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace voxc {

namespace {

/// For each axis of the model the axis of voxels that lies nearest to it: of all ways to give each its own,
/// the one whose directions agree best.
std::array<SliceAxis, 3> axesOfModel(const Transform &voxelToModel) {
  std::array<glm::dvec3, 3> directions;
  for (int axis = 0; axis < 3; ++axis) {
    const double length = glm::length(voxelToModel[axis]);
    directions[std::size_t(axis)] = length > 0 ? voxelToModel[axis] / length : glm::dvec3(0);
  }
  std::array<int, 3> order = {0, 1, 2}, best = order;
  double most = -1;
  do {
    double agreement = 0;
    for (int model = 0; model < 3; ++model)
      agreement += std::abs(directions[std::size_t(order[std::size_t(model)])][model]);
    if (agreement > most) {
      most = agreement;
      best = order;
    }
  } while (std::ranges::next_permutation(order).found);
  std::array<SliceAxis, 3> axes;
  for (std::size_t model = 0; model < 3; ++model)
    axes[model] = {best[model], directions[std::size_t(best[model])][int(model)] < 0};
  return axes;
}

SliceAxis opposite(const SliceAxis &axis) { return {axis.axis, !axis.isBackward}; }

} // namespace

SliceAxes sliceAxes(SlicePlane plane, const Transform &voxelToModel) {
  const auto [x, y, z] = axesOfModel(voxelToModel);
  switch (plane) {
  case SlicePlane::X:
    return {{2}, {1}, {0}};
  case SlicePlane::Y:
    return {{0}, {2}, {1}};
  case SlicePlane::Axial:
    return {x, opposite(y), z};
  case SlicePlane::Coronal:
    return {x, opposite(z), y};
  case SlicePlane::Sagittal:
    return {y, opposite(z), x};
  default:
    return {{0}, {1}, {2}};
  }
}

} // namespace voxc
