// The traversal of a ray from one uniform cube to the next, and where it enters the grid.
#include "ExactTraversal.h"
#include "ExactRay.h"

#include <cmath>
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

/// A ray's first cell that is not empty, and when it gets there.
struct Arrival {
  Moment moment;
  Int3 cell;
};

bool isBefore(const ExactRay &ray, const Moment &moment, float tmin) {
  return tmin > 0 && (std::isinf(tmin) || ray.compareTime(moment, tmin) < 0);
}

bool isAfter(const ExactRay &ray, const Moment &moment, float tmax) {
  return tmax < 0 || (!std::isinf(tmax) && ray.compareTime(moment, tmax) > 0);
}

/// The same between bounds.
std::optional<Arrival> arrive(const VoxelRuns &voxels, const ExactRay &ray, const RayBounds &bounds) {
  if (std::isnan(bounds.tmin) || std::isnan(bounds.tmax))
    return std::nullopt;
  std::optional<Moment> moment = enterGrid(ray, voxels.extent());
  while (moment && !isAfter(ray, *moment, bounds.tmax)) {
    const Int3 cell = cellAt(ray, *moment);
    if (!contains(voxels.extent(), cell))
      break;
    const std::optional<Cube> empty = voxels.emptyAround(cell);
    if (!empty && !isBefore(ray, *moment, bounds.tmin))
      return Arrival{*moment, cell};
    moment = leaveCube(ray, empty.value_or(Cube{cell, 0}));
  }
  return std::nullopt;
}

Hit hitOf(const VoxelRuns &voxels, const ExactRay &ray, const Arrival &arrival) {
  const Int3 cell = arrival.cell;
  return {{cell.x, cell.y, cell.z}, voxels.word(cell), ray.time(arrival.moment), 0};
}

/// The first axis whose coordinate comes into the cell at that very moment.
Face entryFace(const ExactRay &ray, const Arrival &arrival) {
  for (int axis = 0; axis < 3 && arrival.moment.axis >= 0; ++axis) {
    const double direction = ray.direction(axis);
    const int face = arrival.cell[axis] + (direction < 0 ? 1 : 0);
    const bool behind = direction < 0 ? face > ray.origin(axis) : face < ray.origin(axis);
    if (direction != 0 && !behind && ray.compare(ray.crossing(axis, face), arrival.moment) == 0)
      return {axis, direction < 0 ? 1 : -1};
  }
  return {};
}

/// Adds the cells up to the first that is not empty; false if there are more than `maxCells`.
bool listCells(const VoxelRuns &voxels, const ExactRay &ray, std::size_t maxCells, std::vector<Int3> &cells) {
  for (std::optional<Moment> moment = enterGrid(ray, voxels.extent()); moment;) {
    const Int3 cell = cellAt(ray, *moment);
    if (!contains(voxels.extent(), cell))
      break;
    if (cells.size() == maxCells)
      return false;
    cells.push_back(cell);
    if (!voxels.emptyAround(cell))
      break;
    moment = leaveCube(ray, {cell, 0});
  }
  return true;
}

} // namespace

Hit traceExactly(const VoxelRuns &voxels, const Ray &ray, const RayBounds &bounds) {
  if (!isFinite(ray))
    return kMiss;
  const ExactRay exact(ray);
  const std::optional<Arrival> arrival = arrive(voxels, exact, bounds);
  return arrival ? hitOf(voxels, exact, *arrival) : kMiss;
}

Hit hitAtOrigin(const VoxelRuns &voxels, const Ray &ray) {
  Int3 cell;
  for (int axis = 0; axis < 3; ++axis) {
    const double origin = ray.origin[axis];
    if (!(origin >= 0 && origin < voxels.extent()[axis]))
      return kMiss;
    cell[axis] = static_cast<int>(origin);
  }
  const std::uint32_t word = voxels.word(cell);
  return word == 0 ? kMiss : Hit{{cell.x, cell.y, cell.z}, word, 0, 0};
}

Explanation explainExactly(const VoxelRuns &voxels, const Ray &ray, std::size_t maxCells,
                           const RayBounds &bounds) {
  Explanation explanation{kMiss, {}, {}, true};
  if (!isFinite(ray))
    return explanation;
  const ExactRay exact(ray);
  if (const std::optional<Arrival> arrival = arrive(voxels, exact, bounds)) {
    explanation.hit = hitOf(voxels, exact, *arrival);
    explanation.face = entryFace(exact, *arrival);
  }
  explanation.complete = listCells(voxels, exact, maxCells, explanation.cells);
  return explanation;
}

} // namespace voxc
