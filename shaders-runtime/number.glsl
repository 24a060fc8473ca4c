// Float32 numbers as integers: significand * 2^(exponent - 150). No device flushes or rounds these.

const uint SIGN_BIT = 0x80000000u;
const uint INFINITY_BITS = 0x7f800000u;

// Below 2^24.
uint significand_of(uint bits) {
  uint fraction = bits & 0x7fffffu;
  return (bits & INFINITY_BITS) == 0u ? fraction : fraction | 0x800000u;
}

int exponent_of(uint bits) { return max(int(bits >> 23 & 0xffu), 1); }

bool are_finite(uvec3 bits) { return all(lessThan(bits & INFINITY_BITS, uvec3(INFINITY_BITS))); }

// True if each is 0 or has a significand of 24 bits, as devices do not always keep smaller ones.
bool are_plain(uvec3 bits) { return all(greaterThanEqual((bits & ~SIGN_BIT) - 1u, uvec3(0x7fffffu))); }

// 2^exponent, for exponents of normal numbers; the nearest such for others.
float power_of_two(int exponent) { return uintBitsToFloat(uint(clamp(exponent, -126, 127) + 127) << 23); }

// The bits of the longest component's magnitude.
uint longest_of(uvec3 direction) {
  uvec3 size = direction & ~SIGN_BIT;
  return max(max(size.x, size.y), size.z);
}

// The largest whole numbers that are not above float32 numbers, within 2^22 of zero.
ivec3 floor_of(uvec3 bits) {
  ivec3 whole = ivec3(clamp(floor(uintBitsToFloat(bits)), -4194304.0f, 4194304.0f));
  // Below 1, a denormal number may not survive arithmetic.
  ivec3 small = -ivec3(greaterThan(bits, uvec3(SIGN_BIT)));
  return mix(whole, small, lessThan(bits & ~SIGN_BIT, uvec3(0x3f800000u)));
}
