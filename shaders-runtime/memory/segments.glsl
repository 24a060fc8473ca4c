// The volume's words lie in segments of 2^28 words, each at a device address of its own.
const int LOG2_SEGMENT_WORDS = 28;

layout(buffer_reference, std430, buffer_reference_align = 4) readonly buffer Segment { uint words[]; };
layout(std430, set = 0, binding = 2) readonly restrict buffer Segments { uvec2 segments[]; };

// A word of what begins at a granule. An offset is below 2^32 - 2^28, so that no sum has more than 32 bits.
uint load_word(uint granule, uint offset) {
  if (COUNT_WORDS)
    words_read++;
  const int LOG2_SEGMENT = LOG2_SEGMENT_WORDS - LOG2_GRANULE; // In granules.
  uint word = ((granule & ((1u << LOG2_SEGMENT) - 1u)) << LOG2_GRANULE) + offset;
  Segment segment = Segment(segments[(granule >> LOG2_SEGMENT) + (word >> LOG2_SEGMENT_WORDS)]);
  return segment.words[word & ((1u << LOG2_SEGMENT_WORDS) - 1u)];
}

uint load_word(uint place) {
  if (GRANULES)
    return load_word(place, 0u);
  if (COUNT_WORDS)
    words_read++;
  Segment segment = Segment(segments[place >> LOG2_SEGMENT_WORDS]);
  return segment.words[place & ((1u << LOG2_SEGMENT_WORDS) - 1u)];
}
