// The walk of a ray from one uniform cube to the next, and where it enters the grid.
#include "ExactWalk.h"
#include "ExactRay.h"

#include <optional>

namespace voxc {

namespace {

constexpr Hit kMiss = {{-1, -1, -1}, 0, 0, 0};

/// The moments between which a ray is in a slab or a box: from `enter` on, until `leave` (never, without
/// one).
struct Stay {
  Moment enter;
  std::optional<Moment> leave;
};

/// The stay in the cells [0, size) of one axis, if there is one at t >= 0.
std::optional<Stay> slabStay(const ExactRay &ray, int axis, int size) {
  const double origin = ray.origin(axis), direction = ray.direction(axis);
  if (direction == 0)
    return origin >= 0 && origin < size ? std::optional(Stay{}) : std::nullopt;
  if (direction > 0 ? origin >= size : origin < 0)
    return std::nullopt;
  const bool inside = origin >= 0 && origin < size;
  const int near = direction > 0 ? 0 : size;
  return Stay{inside ? Moment{} : ray.crossing(axis, near), ray.crossing(axis, size - near)};
}

/// Whether `a` comes first; a moment that never comes does not.
bool earlier(const ExactRay &ray, const std::optional<Moment> &a, const std::optional<Moment> &b) {
  return a && (!b || ray.compare(*a, *b) < 0);
}

/// When the ray enters the grid, if it has a cell in it: be it for an instant, such as where a rising axis
/// enters at the very time just after which a falling one leaves.
std::optional<Moment> enterGrid(const ExactRay &ray, Int3 extent) {
  Stay stay;
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<Stay> slab = slabStay(ray, axis, extent[axis]);
    if (!slab)
      return std::nullopt;
    if (ray.compare(stay.enter, slab->enter) < 0)
      stay.enter = slab->enter;
    if (earlier(ray, slab->leave, stay.leave))
      stay.leave = slab->leave;
  }
  return !stay.leave || earlier(ray, stay.enter, stay.leave) ? std::optional(stay.enter) : std::nullopt;
}

/// When a ray that is in `cube` leaves it; never, if it does not move.
std::optional<Moment> leaveCube(const ExactRay &ray, const Cube &cube) {
  std::optional<Moment> first;
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction(axis) == 0)
      continue;
    const int side = ray.direction(axis) > 0 ? static_cast<int>(cube.side()) : 0;
    const Moment crossing = ray.crossing(axis, cube.low[axis] + side);
    if (earlier(ray, crossing, first))
      first = crossing;
  }
  return first;
}

Int3 cellAt(const ExactRay &ray, const Moment &moment) {
  return {ray.cell(0, moment), ray.cell(1, moment), ray.cell(2, moment)};
}

} // namespace

Hit traceExactly(const VoxelRuns &voxels, const Ray &ray) {
  if (!isFinite(ray))
    return kMiss;
  const ExactRay exact(ray);
  std::optional<Moment> moment = enterGrid(exact, voxels.extent());
  while (moment) {
    const Int3 cell = cellAt(exact, *moment);
    if (!contains(voxels.extent(), cell))
      return kMiss;
    const UniformCube here = voxels.at(cell);
    if (here.word != 0)
      return {{cell.x, cell.y, cell.z}, here.word, exact.time(*moment), 0};
    moment = leaveCube(exact, here.cube);
  }
  return kMiss;
}

} // namespace voxc
