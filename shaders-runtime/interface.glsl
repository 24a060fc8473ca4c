// Before a function that is seldom called: kernels in C++ keep it out of the loops, into which all others go.
#define OUT_OF_LINE

// A host that wants workgroups of another size says so.
layout(local_size_x = 64, local_size_x_id = 7) in;

// Count the lookups of each ray; off, it costs nothing.
layout(constant_id = 0) const bool COUNT_LOOKUPS = false;
// Count the words that each ray reads, and store that in place of its lookups; off, it costs nothing.
layout(constant_id = 2) const bool COUNT_WORDS = false;
uint words_read = 0u;

// Eight words a ray with bounds, the bits of float32: origin, tmin, direction, tmax.
layout(std430, set = 0, binding = 0) readonly restrict buffer BoundedRays { uvec4 ray_halves[]; };
// Six words a ray without: origin, direction.
layout(std430, set = 0, binding = 0) readonly restrict buffer Rays { uvec2 ray_pairs[]; };
// Six words a hit: voxel, rgba, t, and lookups or words read, else a face.
layout(std430, set = 0, binding = 1) restrict buffer Hits { uvec2 hit_pairs[]; };
// A dispatch without the exact fallback defers the rays that need exact arithmetic to one with it, over these alone:
// what that is started with, how many they are, and their numbers.
layout(std430, set = 0, binding = 3) restrict buffer Deferred {
  uint deferred_groups[3];
  uint deferred_count;
  uint deferred_rays[];
};
layout(constant_id = 3) const bool EXACT_FALLBACK = true;
// Rays that begin far away are moved near the volume; off, where none does, it costs nothing, and those that do are resolved exactly.
layout(constant_id = 6) const bool COMES_NEAR = true;
// The rays of this dispatch; a `task` other than all of them, from their beginning, goes on with rays that were deferred.
layout(push_constant) uniform Tile {
  uint first_ray;
  uint ray_count;
  uint task;
};
const uint ALL = 0u;
const uint DEFERRED = 1u;  // Those of the list.
const uint TRUNCATED = 2u; // Those that are unfinished.
