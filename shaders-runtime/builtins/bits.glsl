// Functions of GLSL on the bits of words that GLSL ES lacks.

int bitCount(uint bits) {
  bits -= bits >> 1 & 0x55555555u;
  bits = (bits & 0x33333333u) + (bits >> 2 & 0x33333333u);
  bits = bits + (bits >> 4) & 0x0f0f0f0fu;
  return int(bits * 0x01010101u >> 24);
}

// The place of the highest bit that is set; -1 if none is.
int findMSB(uint bits) {
  bits |= bits >> 1;
  bits |= bits >> 2;
  bits |= bits >> 4;
  bits |= bits >> 8;
  bits |= bits >> 16;
  return bitCount(bits) - 1;
}

// The place of the lowest bit that is set; -1 if none is.
int findLSB(uint bits) { return bits == 0u ? -1 : bitCount(~bits & (bits - 1u)); }
