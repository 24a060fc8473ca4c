// The volume's words lie in segments of 2^28 words, each at a device address of its own.
const int LOG2_SEGMENT_WORDS = 28;

layout(buffer_reference, std430, buffer_reference_align = 4) readonly buffer Segment { uint words[]; };
layout(std430, set = 0, binding = 2) readonly restrict buffer Segments { uvec2 segments[]; };

uint load_word(uint offset) {
  if (COUNT_WORDS)
    words_read++;
  Segment segment = Segment(segments[offset >> LOG2_SEGMENT_WORDS]);
  return segment.words[offset & ((1u << LOG2_SEGMENT_WORDS) - 1u)];
}
