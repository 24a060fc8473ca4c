// voxc_packets.h: rays side by side, a lane each: what one lane does, and what becomes of its ray.
#pragma once

#include "voxc_rays.h"

namespace {

// What becomes of a ray in a packet.
constexpr uint DONE = 0;
constexpr uint YIELDED = 1;    // It is to go on among others.
constexpr uint PENDING = 2;    // A step is to be resolved.
constexpr uint UNPREPARED = 3; // Its numbers are to be had by exact arithmetic alone.
constexpr uint UNTIMED = 4;    // And the axis: how it arrives is to be had so.
constexpr uint UNPLACED = 8;   // Whether it comes to its cell within its bounds is to be had so.

// The number of no ray.
constexpr uint NONE = ~0u;

// The numbers of a ray that steps ask for.
using Real = RealOf<Plan::DOUBLES>::Type;

// What exact arithmetic has made of rays: the members of Ray that are no integers and that traverses ask for,
// for each lane.
struct Prepared {
  Real numbers[17][LANES];
};

template <typename Ray, typename Function> VOXC_INLINE void for_each_number(Ray &ray, Function function) {
  const auto components = [&](auto &v, uint first) {
    function(v.x, first);
    function(v.y, first + 1);
    function(v.z, first + 2);
  };
  components(ray.origin, 0);
  components(ray.direction, 3);
  components(ray.inverse, 6);
  components(ray.origin_low, 9);
  function(ray.t_error, 12);
  function(ray.cell_margin, 13);
  components(ray.late, 14);
}

// Puts a cell in place of a hit's voxel.
VOXC_INLINE void store_cell(uint *hit, const ivec3 &cell) {
  for (uint axis = 0; axis < 3; axis++)
    hit[axis] = uint(cell[axis]);
}

// Whether a traversal is where a ray may still hit something.
template <typename Kernel>
VOXC_INLINE bool is_inside(Kernel &kernel, const typename Kernel::Traversal &traversal) {
  if constexpr (Plan::BOUNDED)
    return kernel.is_in_reach(traversal);
  else
    return kernel.is_in_volume(traversal.cell);
}

// Traces one ray of a packet.
template <typename Kernel>
VOXC_INLINE uint trace_lane(Kernel kernel, uint ray_number, bool goes_on, const Prepared *prepared,
                            uint lane) {
  const uint at = 6 * ray_number;
  typename Kernel::Traversal traversal = kernel.traversal_at(ivec3(-1));
  if (goes_on)
    traversal = kernel.deferred_traversal(at);
  const uvec3 direction = kernel.load_direction(at);
  const uint root = kernel.load_word(0); // Leads to level 1, unless the volume is empty.
  typename Kernel::Ray ray;
  bool is_active = kernel.begin_traversal(kernel.load_origin(at), direction, root, ray, traversal);
  if (prepared != nullptr) {
    for_each_number(ray, [&](Real &value, uint number) { value = prepared->numbers[number][lane]; });
    traversal = kernel.deferred_traversal(at);
    is_active = true;
  }
  bool hit = false, unplaced = false;
  if constexpr (Plan::BOUNDED) {
    const typename Kernel::Bounds bounds = kernel.bounds_of(at);
    is_active = is_active && kernel.bound_traversal(ray, traversal, bounds);
    if (is_active && prepared == nullptr)
      kernel.skip_to(ray, traversal, bounds.tmin);
    hit = is_active && kernel.traverse_within(ray, traversal, root, bounds);
    unplaced = is_active && traversal.pending_step == Kernel::RETRY;
  } else {
    hit = is_active && kernel.intersect_level_1(ray, traversal, root);
  }
  hit = kernel.end_traversal(kernel.load_origin(at), direction, traversal, hit);
  if constexpr (Plan::PAGED) {
    if constexpr (Plan::COLOUR)
      if (hit)
        traversal.voxel = kernel.colour_of(traversal);
    hit = hit && !kernel.lacks_page; // Else it waits where it is, and has done what it can.
  }
  if (traversal.pending_step != Kernel::NO_PENDING_STEP || (!hit && is_inside(kernel, traversal))) {
    kernel.store_hit(at, kernel.words_of_deferred(traversal));
    if (unplaced)
      return UNPLACED;
    if (traversal.pending_step == Kernel::NO_PENDING_STEP)
      return Plan::PAGED && kernel.lacks_page ? DONE : YIELDED;
    return traversal.pending_step >= 0 ? PENDING : UNPREPARED;
  }
  if constexpr (Plan::ARRIVAL) {
    bool sure;
    const typename Kernel::Arrival arrival = kernel.arrival_at(ray, traversal, hit, sure);
    kernel.store_hit(at, kernel.words_of(traversal, hit, arrival));
    if (!Plan::VOXEL && !sure)
      store_cell(kernel.hit_words + at, traversal.cell); // From which its arrival is found.
    return sure ? DONE : UNTIMED + uint(traversal.axis);
  } else {
    kernel.store_hit(at, kernel.words_without_arrival(traversal, hit));
    return DONE;
  }
}

using Lanes = Kernel<false>;

// Traces the rays of a list, `count` at most LANES, side by side.
VOXC_PART_FUNCTION void trace_packet(const Rays &rays, const uint *list, uint count, bool goes_on,
                                     const Prepared *prepared, uint *outcomes);
#if VOXC_PARTS & VOXC_PART_OF_PACKETS
void trace_packet(const Rays &rays, const uint *list, uint count, bool goes_on, const Prepared *prepared,
                  uint *outcomes) {
  const uint lane = lane_number(LANES);
  if (lane >= count || list[lane] == NONE)
    return;
  const uint ray_number = list[lane] % BATCH; // It is below: so that offsets are seen to be small.
  outcomes[lane] = trace_lane(rays.kernel<Lanes>(), ray_number, goes_on, prepared, lane);
}
#endif

} // namespace
