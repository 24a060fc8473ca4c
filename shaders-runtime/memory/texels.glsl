// The volume's words are the texels of a buffer. Mesa's llvmpipe reads these for all rays of a vector at once, and the words of a storage
// buffer for one after another.
layout(set = 0, binding = 2) uniform utextureBuffer words;

%if granules
// A word of what begins at a granule, of ${granule-words} words.
uint load_word(uint granule, uint offset) {
  if (COUNT_WORDS)
    words_read++;
  return texelFetch(words, int((granule << ${log2-granule}) + offset)).x;
}

uint load_word(uint granule) { return load_word(granule, 0u); }
%else
uint load_word(uint offset) {
  if (COUNT_WORDS)
    words_read++;
  return texelFetch(words, int(offset)).x;
}
%end
