// A word so many words behind where something begins: at an offset, or at a granule.
INLINE uint load_word_at(uint begin, uint offset) { return GRANULES ? load_word(begin, offset) : load_word(begin + offset); }
