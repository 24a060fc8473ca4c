// voxc_exact.h: exact arithmetic, for single rays.
#pragma once

#include "voxc_packets.h"

namespace {

// Makes a ray ready for a lane. False if there is nothing that it could hit.
VOXC_PART_FUNCTION bool prepare(const Rays &rays, uint ray_number, Prepared &prepared, uint lane);

// Does for a ray what its outcome asks for. True if it is to go on.
VOXC_PART_FUNCTION bool go_on_exactly(const Rays &rays, uint ray_number, uint outcome);

#if VOXC_PARTS & VOXC_PART_OF_EXACTNESS
template <typename Exact>
[[gnu::noinline]] bool begin_exactly(Exact &kernel, uint at, bool goes_on, typename Exact::Ray &ray,
                                     typename Exact::Traversal &traversal) {
  traversal = kernel.traversal_at(ivec3(-1));
  if (goes_on)
    traversal = kernel.deferred_traversal(at);
  return kernel.begin_traversal(kernel.load_origin(at), kernel.load_direction(at), kernel.load_word(0), ray,
                                traversal);
}

template <typename Exact>
bool prepare_exactly(const Rays &rays, uint ray_number, Prepared &prepared, uint lane) {
  Exact kernel = rays.kernel<Exact>();
  const uint at = 6 * ray_number;
  typename Exact::Traversal traversal;
  typename Exact::Ray ray;
  if (!begin_exactly(kernel, at, Plan::PAGED, ray, traversal)) {
    kernel.store_hit(at, kernel.words_without_arrival(traversal, false));
    return false;
  }
  if constexpr (Plan::BOUNDED) {
    const typename Exact::Bounds bounds = kernel.bounds_of(at);
    if (!kernel.bound_traversal(ray, traversal, bounds)) {
      kernel.store_hit(at, kernel.words_without_arrival(traversal, false));
      return false;
    }
    kernel.skip_to(ray, traversal, bounds.tmin);
  }
  for_each_number(ray, [&](Real &value, uint number) { prepared.numbers[number][lane] = value; });
  kernel.store_hit(at, kernel.words_of_deferred(traversal));
  count_deferred(rays, ray_number);
  return true;
}

// Resolves the pending step of a ray. False if that has brought it out of the volume.
template <typename Exact> [[gnu::noinline]] bool resolve_exactly(const Rays &rays, uint ray_number) {
  Exact kernel = rays.kernel<Exact>();
  const uint at = 6 * ray_number;
  typename Exact::Traversal traversal;
  typename Exact::Ray ray;
  begin_exactly(kernel, at, true, ray, traversal);
  if constexpr (Plan::EXACT)
    kernel.resolve_step(ray, traversal);
  const bool stays = kernel.is_in_volume(traversal.cell);
  if (stays)
    kernel.store_hit(at, kernel.words_of_deferred(traversal));
  else
    kernel.store_hit(at, kernel.words_without_arrival(traversal, false));
  count_deferred(rays, ray_number);
  return stays;
}

// Places the entry of a ray into its voxel: it is taken, or the traversal goes on behind it. False if the
// traversal has ended.
template <typename Exact> [[gnu::noinline]] bool place(const Rays &rays, uint ray_number) {
  Exact kernel = rays.kernel<Exact>();
  const uint at = 6 * ray_number;
  typename Exact::Traversal traversal;
  typename Exact::Ray ray;
  begin_exactly(kernel, at, true, ray, traversal);
  const int order = kernel.place_of_entry(ray, traversal, kernel.bounds_of(at));
  if (order < 0) {
    kernel.step_over_voxel(ray, traversal);
    if constexpr (Plan::EXACT)
      if (traversal.pending_step >= 0)
        kernel.resolve_step(ray, traversal);
  }
  const bool stays = order <= 0 && kernel.is_in_volume(traversal.cell);
  traversal.pending_step = order == 0 ? Exact::IN_BOUNDS : Exact::NO_PENDING_STEP;
  if (!stays)
    traversal.cell = ivec3(-1);
  if (stays)
    kernel.store_hit(at, kernel.words_of_deferred(traversal));
  else
    kernel.store_hit(at, kernel.words_without_arrival(traversal, false));
  count_deferred(rays, ray_number);
  return stays;
}

// Finds how a ray arrives at a hit, on whose cell it came by an axis.
template <typename Exact> [[gnu::noinline]] void find_arrival(const Rays &rays, uint ray_number, int axis) {
  Exact kernel = rays.kernel<Exact>();
  const uint at = 6 * ray_number;
  typename Exact::Traversal traversal;
  typename Exact::Ray ray;
  begin_exactly(kernel, at, false, ray, traversal);
  uint *hit = rays.hit_words + at;
  traversal.cell = ivec3(int(hit[0]), int(hit[1]), int(hit[2]));
  traversal.axis = axis;
  if constexpr (Plan::T)
    hit[4] = kernel.time_exactly(ray, axis, kernel.entered_face(ray, traversal));
  if constexpr (Plan::FACE)
    if (!Exact::COUNT_WORDS && !rays.count_lookups) {
      bool sure;
      const int first = kernel.first_axis(ray, traversal, sure);
      hit[5] = 2 * uint(first) + uint(ray.falls[first]);
    }
  if constexpr (!Plan::VOXEL)
    store_cell(hit, ivec3(0));
  count_deferred(rays, ray_number);
}

template <typename Exact> bool go_on(const Rays &rays, uint ray_number, uint outcome) {
  if constexpr (Plan::BOUNDED)
    if (outcome == UNPLACED)
      return place<Exact>(rays, ray_number);
  if constexpr (Plan::ARRIVAL)
    if (outcome >= UNTIMED) {
      find_arrival<Exact>(rays, ray_number, int(outcome - UNTIMED));
      return false;
    }
  return resolve_exactly<Exact>(rays, ray_number);
}

bool prepare(const Rays &rays, uint ray_number, Prepared &prepared, uint lane) {
  return prepare_exactly<Kernel<true>>(rays, ray_number, prepared, lane);
}

bool go_on_exactly(const Rays &rays, uint ray_number, uint outcome) {
  return go_on<Kernel<true>>(rays, ray_number, outcome);
}
#endif

} // namespace
