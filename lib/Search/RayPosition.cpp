// A ray on its way through cells.
#include "RayPosition.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace voxc {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::size_t kNoAxis = 3;

} // namespace

RayPosition::RayPosition(const Ray &ray, int side) : side_(side) {
  bool isFinite = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    isFinite &= std::isfinite(ray.origin[axis]) && std::isfinite(ray.direction[axis]);
    origin_[axis] = static_cast<double>(ray.origin[axis]);
    direction_[axis] = static_cast<double>(ray.direction[axis]);
    if (direction_[axis] > 0)
      octant_ |= 1u << axis;
  }
  std::size_t entered = kNoAxis;
  const double t = isFinite ? enter(entered) : kNever;
  for (std::size_t axis = 0; axis < 3; ++axis)
    cell_[axis] = !(t < kNever)     ? -1
                  : axis == entered ? (rises(axis) ? 0 : side - 1)
                                    : std::clamp(cellAt(axis, t), 0, side - 1);
}

/// When the ray comes into the volume, and through a face of which axis; never if it misses.
double RayPosition::enter(std::size_t &axis) const {
  double first = 0;
  double last = kNever;
  for (std::size_t i = 0; i < 3; ++i) {
    if (direction_[i] == 0) {
      if (!(origin_[i] >= 0 && origin_[i] < side_))
        return kNever;
      continue;
    }
    const double low = -origin_[i] / direction_[i];
    const double high = (side_ - origin_[i]) / direction_[i];
    if (std::min(low, high) > first) {
      first = std::min(low, high);
      axis = i;
    }
    last = std::min(last, std::max(low, high));
  }
  return first < last ? first : kNever;
}

int RayPosition::cellAt(std::size_t axis, double t) const {
  return static_cast<int>(std::floor(std::clamp(origin_[axis] + t * direction_[axis], -1.0, double(side_))));
}

void RayPosition::leave(const EmptySpan &span) {
  const int unit = 1 << span.log2Side;
  const int size = span.count << span.log2Side;
  std::array<int, 3> low{};
  double first = kNever;
  std::size_t left = kNoAxis;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int corner = cell_[axis] & -unit;
    low[axis] = rises(axis) ? corner : corner + unit - size;
    const double t = direction_[axis] == 0
                         ? kNever
                         : ((rises(axis) ? low[axis] + size : low[axis]) - origin_[axis]) / direction_[axis];
    if (t < first) {
      first = t;
      left = axis;
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    cell_[axis] = axis == left      ? (rises(axis) ? low[axis] + size : low[axis] - 1)
                  : left == kNoAxis ? -1
                                    : std::clamp(cellAt(axis, first), low[axis], low[axis] + size - 1);
}

int commonHeight(Int3 a, Int3 b) {
  return static_cast<int>(std::bit_width(static_cast<unsigned>((a.x ^ b.x) | (a.y ^ b.y) | (a.z ^ b.z))));
}

bool areInOneCube(Int3 a, Int3 b, int height) { return commonHeight(a, b) <= height; }

} // namespace voxc
