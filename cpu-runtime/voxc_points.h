// voxc_points.h: batches of points, side by side. `VOXC_SYMBOL` is what the kernel is called.
#pragma once

#include "voxc_rays.h"

#if VOXC_PARTS & VOXC_PART_OF_BATCHES
namespace {

// Answers `count` points from one on, at most LANES, side by side.
[[gnu::noinline]] void answer_packet(const Rays &rays, uint first, uint count) {
  const uint lane = lane_number(LANES);
  if (lane >= count)
    return;
  const uint number = (first + lane) % BATCH; // It is below: so that offsets are seen to be small.
  rays.kernel<Kernel<false>>().answer(6 * number);
}

void answer_batch(const Rays &rays, uint count) {
  for (uint first = 0; first < count; first += LANES) {
    fetch_packet(rays, first + 2 * LANES);
    answer_packet(rays, first, min(count - first, LANES));
  }
}

} // namespace

#include "voxc_kernel_entry.h"
#endif
