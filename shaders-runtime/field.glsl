// The field of so many bits, 32 at most, whose first is that bit of those from a word on.
uint load_field_at(${uint-section,}uint at, uint first, uint bits) {
  uint low = load_word(${section,}at + (first >> 5));
  uint high = load_word(${section,}at + (first >> 5) + 1u);
  uint word = low >> (first & 31u) | (high << 1) << (31u - (first & 31u));
  return bits == 32u ? word : word & ((1u << bits) - 1u);
}

// Field i of those of so many bits that begin at a word.
uint load_field(${uint-section,}uint at, uint i, uint bits) { return load_field_at(${section,}at, i * bits, bits); }
