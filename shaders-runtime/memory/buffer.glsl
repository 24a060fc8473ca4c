// The volume's words lie in one storage buffer.
layout(std430, set = 0, binding = 2) readonly restrict buffer Words { uint words[]; };

%if granules
// A word of what begins at a granule, of ${granule-words} words.
uint load_word(uint granule, uint offset) {
  if (COUNT_WORDS)
    words_read++;
  return words[(granule << ${log2-granule}) + offset];
}

uint load_word(uint granule) { return load_word(granule, 0u); }
%else
uint load_word(uint offset) {
  if (COUNT_WORDS)
    words_read++;
  return words[offset];
}
%end
