// voxc_interface.h: what a kernel in C++ has in place of a device's buffers and specialization constants:
// pointers, and numbers that are known when it begins.
#pragma once

#include "voxc_glsl.h"
#include "voxc_lanes.h"

namespace voxc::glsl {

// float, or where steps are of doubles double.
template <bool DOUBLES> struct RealOf {
  using Type = float;
};
template <> struct RealOf<true> {
  using Type = double;
};

// Members of a kernel; `Plan` has what its plan decides.
template <typename Plan> struct Interface {
  // Rays that begin far away are moved near the volume.
  static constexpr bool COMES_NEAR = true;
  // Count the words that the ray reads, and store that in place of its lookups.
  static constexpr bool COUNT_WORDS = Plan::COUNT_WORDS;

  // The volume's words. Of a volume in pages those that are here, each page in a slot; the first slot has
  // zeros, for those that are not.
  const uint *words;
  // Six words of a ray, the bits of floats: origin, direction; with bounds eight: origin, tmin, direction,
  // tmax.
  const uint *ray_words;
  // Six words of a hit: voxel, rgba, t, lookups or words read, or else a face.
  uint *hit_words;
  // Count the lookups of each ray. A choice at run time: it costs next to nothing, and a second kernel twice
  // the compile time.
  bool COUNT_LOOKUPS;
  // A traversal is let go where fewer lanes than these are at work.
  uint FEWEST_LANES;
  // How wide a ray's cone grows for each voxel of its length, in kernels that stop at what looks smaller.
  float SPREAD;

  // An entry for each page of a volume, and one for all that lies beyond them, which is never absent.
  uint *page_table = nullptr;
  uint LOG2_PAGE_WORDS = 0;
  uint PAGES = 0;
  bool lacks_page = false;

  uint words_read = 0;

  // A word of what begins at a granule. A kernel of pages has a function of its own in place of these.
  VOXC_INLINE uint load_word(uint granule, uint offset) {
    if (COUNT_WORDS)
      words_read++;
    return words[((unsigned long long)(granule) << Plan::LOG2_GRANULE) + offset];
  }
  VOXC_INLINE uint load_word(uint granule) { return load_word(granule, 0u); }
};

} // namespace voxc::glsl
