// Fitting a model's bounds into voxels.
#include "Mesh/ModelFrame.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace voxc {

namespace {

std::string toText(Int3 extent) {
  return std::to_string(extent.x) + "x" + std::to_string(extent.y) + "x" + std::to_string(extent.z);
}

Double3 turned(const Double3 &point, bool zUp) {
  return zUp ? Double3{point[0], point[2], -point[1]} : point;
}

/// Voxels on each axis with `resolution` of them on the longest.
Int3 extentAt(const Double3 &size, double longest, int resolution) {
  Int3 extent{1, 1, 1};
  for (int axis = 0; axis < 3; ++axis) {
    const double share = longest > 0 ? size[static_cast<std::size_t>(axis)] / longest : 0;
    extent[axis] = std::max(1, static_cast<int>(std::ceil(share * resolution)));
  }
  return extent;
}

bool fits(Int3 extent, Int3 max) { return extent.x <= max.x && extent.y <= max.y && extent.z <= max.z; }

/// The largest resolution whose extent fits.
int largestResolution(const Double3 &size, double longest, Int3 max) {
  int low = 1;
  int high = std::max({max.x, max.y, max.z});
  while (low < high) {
    const int middle = low + (high - low + 1) / 2;
    if (fits(extentAt(size, longest, middle), max))
      low = middle;
    else
      high = middle - 1;
  }
  return low;
}

} // namespace

void BoundsBuilder::add(const Double3 &point) {
  if (!bounds_)
    bounds_ = {point, point};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bounds_->low[axis] = std::min(bounds_->low[axis], point[axis]);
    bounds_->high[axis] = std::max(bounds_->high[axis], point[axis]);
  }
}

Expected<ModelFrame> ModelFrame::fit(const FrameOptions &options) {
  const Double3 a = turned(options.bounds.low, options.zUp);
  const Double3 b = turned(options.bounds.high, options.zUp);
  ModelFrame frame;
  frame.zUp_ = options.zUp;
  Double3 size;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(options.bounds.low[axis] <= options.bounds.high[axis]) || !std::isfinite(b[axis] - a[axis]))
      return Error::input("the bounds are not a box: each low corner must be a number below the high one");
    frame.origin_[axis] = std::min(a[axis], b[axis]);
    size[axis] = std::abs(b[axis] - a[axis]);
  }
  const double longest = *std::max_element(size.begin(), size.end());
  const int resolution =
      options.resolution > 0 ? options.resolution : largestResolution(size, longest, options.maxExtent);
  frame.extent_ = extentAt(size, longest, resolution);
  if (!fits(frame.extent_, options.maxExtent))
    return Error::input("at resolution " + std::to_string(resolution) + " the model takes " +
                        toText(frame.extent_) + " voxels, but the format holds " + toText(options.maxExtent) +
                        "; lower the resolution or enlarge the format");
  // A single point, or bounds so small that their inverse overflows, has no scale of its own.
  const double scale = resolution / longest;
  frame.scale_ = longest > 0 && std::isfinite(scale) ? scale : 1;
  return frame;
}

Double3 ModelFrame::toVoxels(const Double3 &point) const {
  Double3 voxel = turned(point, zUp_);
  for (std::size_t axis = 0; axis < 3; ++axis)
    voxel[axis] = (voxel[axis] - origin_[axis]) * scale_;
  return voxel;
}

Transform ModelFrame::voxelToModel() const {
  const double unit = 1 / scale_;
  if (!zUp_)
    return {{unit, 0, 0, origin_[0], 0, unit, 0, origin_[1], 0, 0, unit, origin_[2]}};
  return {{unit, 0, 0, origin_[0], 0, 0, -unit, -origin_[2], 0, unit, 0, origin_[1]}};
}

} // namespace voxc
