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

// Answers `count` points, six floats each, from the words of a volume by as many hits, six words each.
extern "C" void VOXC_SYMBOL(const uint *words, const float *rays, uint *hits, unsigned long long count,
                            int count_lookups, float spread) {
  const uint *ray_words = reinterpret_cast<const uint *>(rays);
  for (unsigned long long first = 0; first < count; first += BATCH) {
    const Rays batch = {words,  ray_words + RAY_WORDS * first,     hits + 6 * first, count_lookups != 0, 0,
                        spread, count_lookups == 2 ? 1u << 16 : 0u};
    answer_batch(batch, count - first < BATCH ? uint(count - first) : BATCH);
  }
}
#endif
