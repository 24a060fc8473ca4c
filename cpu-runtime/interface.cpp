// The volume's words.
const uint *words;
// Six words of a ray, the bits of floats: origin, direction.
const uint *ray_words;
// Six words of a hit: voxel, rgba, t, lookups or words read.
uint *hit_words;
// Count the lookups of each ray. A choice at run time: it costs next to nothing, and a second kernel twice the
// compile time.
bool COUNT_LOOKUPS;
// How wide a ray's cone grows for each voxel of its length, in kernels that stop at what looks smaller.
float SPREAD;

// Count the words that the ray reads, and store that in place of its lookups.
static constexpr bool COUNT_WORDS = THE_COUNT_WORDS;
uint words_read = 0;

// Every ray is a dispatch of its own, and nothing cuts it short.
static constexpr struct {
  uint x;
} gl_GlobalInvocationID = {0};
static constexpr uint first_ray = 0;
static constexpr uint ray_count = 1;
static constexpr uint resumes = 0;

uint load_word(uint offset) {
  if (COUNT_WORDS)
    words_read++;
  return words[offset];
}
