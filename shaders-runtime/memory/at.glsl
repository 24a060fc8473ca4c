// A word so many words behind where something begins: at an offset, or at a granule.
INLINE uint load_word_at(uint begin, uint offset) { return GRANULES ? load_word(begin, offset) : load_word(begin + offset); }

// The same in two steps, for several words of one thing: the place of a word, and what stands there.
INLINE uint place_of_word(uint begin, uint offset) { return GRANULES ? offset : begin + offset; }
INLINE uint load_word_from(uint begin, uint place) { return GRANULES ? load_word(begin, place) : load_word(place); }
