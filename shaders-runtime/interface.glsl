// Before a function that is seldom called: kernels in C++ keep it out of the loops, into which all others go.
#define OUT_OF_LINE

layout(local_size_x = 64) in;

// Count the lookups of each ray; off, it costs nothing.
layout(constant_id = 0) const bool COUNT_LOOKUPS = false;
// Count the words that each ray reads, and store that in place of its lookups; off, it costs nothing.
layout(constant_id = 2) const bool COUNT_WORDS = false;
uint words_read = 0u;

// Six words a ray, the bits of float32: origin, direction.
layout(std430, set = 0, binding = 0) readonly restrict buffer Rays { uint ray_words[]; };
// Six words a hit: voxel, rgba, t, lookups or words read.
%if cut
layout(std430, set = 0, binding = 1) restrict buffer Hits { uint hit_words[]; };
%else
layout(std430, set = 0, binding = 1) writeonly restrict buffer Hits { uint hit_words[]; };
%end
%if cut
// The rays of this dispatch; `resumes` is 1 for those that an earlier dispatch left unfinished.
%else
// The rays of this dispatch.
%end
%if cut
layout(push_constant) uniform Tile { uint first_ray; uint ray_count; uint resumes; };
%else
layout(push_constant) uniform Tile { uint first_ray; uint ray_count; };
%end
