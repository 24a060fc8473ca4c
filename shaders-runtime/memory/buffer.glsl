// The volume's words lie in one storage buffer.
layout(std430, set = 0, binding = 2) readonly restrict buffer Words { uint words[]; };

// A word of what begins at a granule.
uint load_word(uint granule, uint offset) {
  if (COUNT_WORDS)
    words_read++;
  return words[(granule << LOG2_GRANULE) + offset];
}

uint load_word(uint place) {
  if (GRANULES)
    return load_word(place, 0u);
  if (COUNT_WORDS)
    words_read++;
  return words[place];
}
