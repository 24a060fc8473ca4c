// Functions of GLSL on words with carries that other languages lack.

uint uaddCarry(uint a, uint b, out uint carry) {
  uint sum = a + b;
  carry = sum < a ? 1u : 0u;
  return sum;
}

uint usubBorrow(uint a, uint b, out uint borrow) {
  borrow = a < b ? 1u : 0u;
  return a - b;
}

// By halves of 16 bits.
void umulExtended(uint a, uint b, out uint high, out uint low) {
  uint a_low = a & 0xffffu;
  uint a_high = a >> 16;
  uint b_low = b & 0xffffu;
  uint b_high = b >> 16;
  uint lowest = a_low * b_low;
  uint middle = a_high * b_low + (lowest >> 16);
  uint other = a_low * b_high + (middle & 0xffffu);
  high = a_high * b_high + (middle >> 16) + (other >> 16);
  low = other << 16 | lowest & 0xffffu;
}
