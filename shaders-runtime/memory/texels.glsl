// The volume's words are the texels of a buffer. Mesa's llvmpipe reads these for all rays of a vector at once, and the words of a storage
// buffer for one after another.
layout(set = 0, binding = 2) uniform utextureBuffer words;

// A word of what begins at a granule.
uint load_word(uint granule, uint offset) {
  if (COUNT_WORDS)
    words_read++;
  return texelFetch(words, int((granule << LOG2_GRANULE) + offset)).x;
}

uint load_word(uint place) {
  if (GRANULES)
    return load_word(place, 0u);
  if (COUNT_WORDS)
    words_read++;
  return texelFetch(words, int(place)).x;
}
