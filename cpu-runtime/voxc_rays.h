// voxc_rays.h: rays that a kernel is put to work on. The file that includes this has named `Plan`, what its
// plan decides, and `Kernel`, which says what becomes of one ray, with the exact fallback and without.
#pragma once

#include "voxc_interface.h"

namespace {

using namespace voxc::glsl;

// Words of a ray.
constexpr uint RAY_WORDS = Plan::BOUNDED ? 8 : 6;

// What `words` leads to of a volume that is here in parts: CpuPages of voxc/Trace/CpuKernel.h.
struct Pages {
  const uint *slots;
  uint *table;
  uint log2_page_words;
  uint pages;
  uint goes_on; // With rays that wait; else all are traced from their beginning.
};

// Rays at work.
struct Rays {
  const uint *words; // The volume's.
  const uint *ray_words;
  uint *hit_words;
  bool count_lookups;
  uint fewest_lanes; // That a packet goes on with.
  float spread;
  uint deferred_lookups; // What a step that exact arithmetic resolves adds to the look-ups that are counted.
  bool in_packets = true;

  template <typename Kernel> Kernel kernel() const {
    if constexpr (Plan::PAGED) {
      const Pages &pages = *reinterpret_cast<const Pages *>(words);
      return {{pages.slots, ray_words, hit_words, count_lookups, fewest_lanes, spread, pages.table,
               pages.log2_page_words, pages.pages}};
    } else {
      return {{words, ray_words, hit_words, count_lookups, fewest_lanes, spread}};
    }
  }
};

// Counts what exact arithmetic has done for a ray.
inline void count_deferred(const Rays &rays, uint ray_number) {
  if (rays.deferred_lookups != 0)
    rays.hit_words[6 * ray_number + 5] += rays.deferred_lookups;
}

// Few enough for what belongs to them to stay near.
constexpr uint BATCH = 2048;

// Sends for the rays of a packet to come, and for where their hits will stand. Gathers and scatters alone
// wait for each line.
void fetch_packet(const Rays &rays, uint ray_number) {
  constexpr uint LINE = 16; // In words.
  for (uint word = 0; word < RAY_WORDS * LANES; word += LINE)
    __builtin_prefetch(rays.ray_words + RAY_WORDS * ray_number + word);
  for (uint word = 0; word < 6 * LANES; word += LINE)
    __builtin_prefetch(rays.hit_words + 6 * ray_number + word, 1);
}

} // namespace
