// The volume's words lie in one storage buffer.
layout(std430, set = 0, binding = 2) readonly restrict buffer Words { uint words[]; };

uint load_word(uint offset) {
  if (COUNT_WORDS)
    words_read++;
  return words[offset];
}
