// Choosing the grid of fixed point, and rounding to it.
#include "Mesh/Voxelize/SnapGrid.h"

#include <bit>
#include <cmath>
#include <string>

namespace voxc {

namespace {

/// The nearest integer, halfway to the even one; |value| < 2^51. Adding this number leaves no room for a
/// fraction, and what then stands in the low bits is the integer.
std::int64_t nearestInteger(double value) {
  constexpr double kNoFraction = 0x1.8p52;
  return std::bit_cast<std::int64_t>(value + kNoFraction) - std::bit_cast<std::int64_t>(kNoFraction);
}

/// The largest distance of a coordinate from the volume's low corner.
double reachOf(const ModelFrame &frame, const Bounds &model) {
  double reach = 0;
  for (const glm::dvec3 &corner : {frame.toVoxels(model.low), frame.toVoxels(model.high)})
    for (int axis = 0; axis < 3; ++axis)
      reach = std::fmax(reach, std::abs(corner[axis]));
  return reach;
}

} // namespace

Expected<SnapGrid> SnapGrid::fit(const ModelFrame &frame, const Bounds &model) {
  SnapGrid grid(frame);
  const double reach = reachOf(frame, model);
  while (grid.bits_ >= kLeastBits && reach * grid.steps_ >= 0x1p39) {
    --grid.bits_;
    grid.steps_ /= 2;
  }
  if (grid.bits_ < kLeastBits)
    return Error::input(
        "the model reaches " + std::to_string(reach) +
        " voxels out of the volume, and the most is 2^35; lower the resolution or widen the bounds");
  return grid;
}

Point64 SnapGrid::snap(const glm::dvec3 &point) const {
  const glm::dvec3 voxel = frame_.toVoxels(point);
  return {nearestInteger(voxel[0] * steps_), nearestInteger(voxel[1] * steps_),
          nearestInteger(voxel[2] * steps_)};
}

} // namespace voxc
