// Float32 numbers as integers: significand * 2^(exponent - 150). No device flushes or rounds these.

const uint SIGN_BIT = 0x80000000u;
const uint INFINITY_BITS = 0x7f800000u;

// Below 2^24.
uint significand_of(uint bits) {
  uint fraction = bits & 0x7fffffu;
  return (bits & INFINITY_BITS) == 0u ? fraction : fraction | 0x800000u;
}

int exponent_of(uint bits) { return max(int(bits >> 23 & 0xffu), 1); }

bool is_finite(uint bits) { return (bits & INFINITY_BITS) != INFINITY_BITS; }

// 2^exponent, for exponents of normal numbers; the nearest such for others.
float power_of_two(int exponent) { return uintBitsToFloat(uint(clamp(exponent, -126, 127) + 127) << 23); }

// The largest whole number that is not above a float32, within 2^22 of zero.
int floor_of(uint bits) {
  if ((bits & ~SIGN_BIT) < 0x3f800000u) // Below 1, where a denormal number may not survive arithmetic.
    return bits > SIGN_BIT ? -1 : 0;
  return int(clamp(floor(uintBitsToFloat(bits)), -4194304.0f, 4194304.0f));
}
