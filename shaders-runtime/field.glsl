// The field of so many bits, 32 at most, whose first is that bit of those from a word of `begin` on.
uint load_field_at(uint begin, uint place, uint first, uint bits) {
  uint low = load_word_from(begin, place + (first >> 5));
  uint high = load_word_from(begin, place + (first >> 5) + 1u);
  uint word = low >> (first & 31u) | (high << 1) << (31u - (first & 31u));
  return bits == 32u ? word : word & ((1u << bits) - 1u);
}

// Field i of those of so many bits that begin at a word.
uint load_field(uint begin, uint place, uint i, uint bits) { return load_field_at(begin, place, i * bits, bits); }
