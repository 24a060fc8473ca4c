// voxc_kernel_entry.h: what callers see of a kernel, `VOXC_SYMBOL`; `answer_batch` is there.
#pragma once

#include "voxc_rays.h"

// Answers `count` rays, six floats each, with bounds eight, or points, from the words of a volume by as many
// hits, six words each.
extern "C" void VOXC_SYMBOL(const uint *words, const float *rays, uint *hits, unsigned long long count,
                            int count_lookups, float spread) {
  const uint *ray_words = reinterpret_cast<const uint *>(rays);
  for (unsigned long long first = 0; first < count; first += BATCH) {
    const Rays batch = {words,  ray_words + RAY_WORDS * first,     hits + 6 * first, count_lookups != 0, 0,
                        spread, count_lookups == 2 ? 1u << 16 : 0u};
    answer_batch(batch, count - first < BATCH ? uint(count - first) : BATCH);
  }
}
