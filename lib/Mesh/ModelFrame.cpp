// Fitting a model's bounds into voxels.
#include "Mesh/ModelFrame.h"

#include "Source/GridExtent.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace voxc {

namespace {

std::string numberText(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", number);
  return text.data();
}

glm::dvec3 turned(const glm::dvec3 &point, bool zUp) {
  return zUp ? glm::dvec3{point[0], point[2], -point[1]} : point;
}

/// What a size is above a whole number of voxels for no other reason than rounding, as of a model that was
/// turned. Corners snap to steps far larger than that.
constexpr double kNothing = 0x1p-24;

/// Voxels on each axis with `resolution` of them on the longest.
Int3 extentAt(const glm::dvec3 &size, double longest, int resolution) {
  Int3 extent{1, 1, 1};
  for (int axis = 0; axis < 3; ++axis) {
    const double share = longest > 0 ? size[axis] / longest : 0;
    extent[axis] = std::max(1, static_cast<int>(std::ceil(share * resolution - kNothing)));
  }
  return extent;
}

bool fits(Int3 extent, Int3 max) { return extent.x <= max.x && extent.y <= max.y && extent.z <= max.z; }

/// The largest resolution whose extent fits.
int largestResolution(const glm::dvec3 &size, double longest, Int3 max) {
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

void BoundsBuilder::add(const glm::dvec3 &point) {
  if (!bounds_)
    bounds_ = {point, point};
  bounds_->low = glm::min(bounds_->low, point);
  bounds_->high = glm::max(bounds_->high, point);
}

Expected<ModelFrame> ModelFrame::fit(const FrameOptions &options) {
  const glm::dvec3 a = turned(options.bounds.low, options.zUp);
  const glm::dvec3 b = turned(options.bounds.high, options.zUp);
  ModelFrame frame;
  frame.zUp_ = options.zUp;
  const glm::dvec3 size = glm::abs(b - a);
  for (int axis = 0; axis < 3; ++axis)
    if (!(options.bounds.low[axis] <= options.bounds.high[axis]) || !std::isfinite(size[axis]))
      return Error::input("the bounds are not a box: each low corner must be a number below the high one");
  frame.origin_ = glm::min(a, b);
  if (options.voxelSize > 0 || options.align) {
    VOXC_TRY(frame.place(options, glm::min(a, b), glm::max(a, b)));
    return frame;
  }
  const double longest = std::max({size.x, size.y, size.z});
  const int resolution =
      options.resolution > 0 ? options.resolution : largestResolution(size, longest, options.maxExtent);
  frame.extent_ = extentAt(size, longest, resolution);
  if (!fits(frame.extent_, options.maxExtent))
    return Error::input("at resolution " + std::to_string(resolution) + " the model takes " +
                        extentText(frame.extent_) + " voxels, but the format holds " +
                        extentText(options.maxExtent) + "; lower the resolution or enlarge the format");
  // A single point, or bounds so small that their inverse overflows, has no scale of its own.
  const double scale = resolution / longest;
  frame.scale_ = longest > 0 && std::isfinite(scale) ? scale : 1;
  return frame;
}

Expected<void> ModelFrame::place(const FrameOptions &options, const glm::dvec3 &low, const glm::dvec3 &high) {
  constexpr double kRounding = 0x1p-24; // Of a voxel: less than that is none.
  const glm::dvec3 size = high - low;
  const double longest = std::max({size.x, size.y, size.z});
  double side = options.voxelSize;
  if (side <= 0) {
    // A voxel more may be needed than the resolution: one less is what surely fits.
    const int fitting = std::max(1, largestResolution(size, longest, options.maxExtent) - 1);
    const double wanted = longest / (options.resolution > 0 ? options.resolution : fitting);
    side = wanted > 0 && std::isfinite(1 / wanted) ? wanted : 1;
  }
  if (!std::isfinite(1 / side))
    return Error::input("a voxel's side of " + numberText(side) + " is too small to be one");
  scale_ = 1 / side;
  const glm::dvec3 point = options.align ? turned(*options.align, options.zUp) : low;
  for (int axis = 0; axis < 3; ++axis) {
    origin_[axis] = point[axis] + std::floor((low[axis] - point[axis]) / side + kRounding) * side;
    const double voxels = std::ceil((high[axis] - origin_[axis]) / side - kRounding);
    extent_[axis] = static_cast<std::int32_t>(std::clamp(voxels, 1.0, 2147483647.0));
  }
  if (!fits(extent_, options.maxExtent))
    return Error::input("with voxels of side " + numberText(side) + " the model takes " +
                        extentText(extent_) + " voxels, but the format holds " +
                        extentText(options.maxExtent) + "; make the voxels larger or the format");
  return {};
}

glm::dvec3 ModelFrame::toVoxels(const glm::dvec3 &point) const {
  return (turned(point, zUp_) - origin_) * scale_;
}

Transform ModelFrame::voxelToModel() const {
  const double unit = 1 / scale_;
  if (!zUp_)
    return transformOfRows({unit, 0, 0, origin_.x, 0, unit, 0, origin_.y, 0, 0, unit, origin_.z});
  return transformOfRows({unit, 0, 0, origin_.x, 0, 0, -unit, -origin_.z, 0, unit, 0, origin_.y});
}

} // namespace voxc
