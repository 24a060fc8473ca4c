// The exact sign of a sum of four products of float32 numbers.

// A sum in two's complement, times 2^(exponent - 300). Its sign is exact, its value within 2^-11 of itself.
struct Sum {
  int high;
  uint low;
  int exponent;
  bool complete; // Unless the device cut the work short.
};

int sign_of(const Sum sum) { return sum.high < 0 ? -1 : (uint(sum.high) | sum.low) != 0u ? 1 : 0; }

// The largest p for which 2^p is not above the magnitude; -1 for 0, and for -1 too.
int log2_of(const Sum sum) {
  uint flip = uint(sum.high >> 31);
  uint high = uint(sum.high) ^ flip;
  return findMSB(high != 0u ? high : sum.low ^ flip) + (high != 0u ? 32 : 0);
}

// Makes `shift` bits, at most 61, of room at the low end.
void shift_left(inout Sum sum, int shift) {
  uint high = uint(sum.high);
  if (shift >= 32) {
    high = sum.low << (shift - 32);
    sum.low = 0u;
  } else if (shift > 0) {
    high = high << shift | sum.low >> (32 - shift);
    sum.low <<= shift;
  }
  sum.high = int(high);
  sum.exponent -= shift;
}

void add(inout Sum sum, uint high, uint low, bool negative) {
  uint flip = negative ? ~0u : 0u;
  uint carry_of_low, carry_of_sign;
  uint partial = uaddCarry(sum.low, low ^ flip, carry_of_low);
  sum.low = uaddCarry(partial, flip & 1u, carry_of_sign);
  sum.high = int(uint(sum.high) + (high ^ flip) + carry_of_low + carry_of_sign);
}

// a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w, of bits of float32. A product is below 2^48 times its power of two.
// They are added from the largest power down; once the sum has 61 bits at the next power, all that is left is too small
// to change its sign.
OUT_OF_LINE Sum sum_of_products(uvec4 a, uvec4 b) {
  ivec4 exponent = ivec4(exponent_of(a.x) + exponent_of(b.x), exponent_of(a.y) + exponent_of(b.y),
                         exponent_of(a.z) + exponent_of(b.z), exponent_of(a.w) + exponent_of(b.w));
  Sum sum = Sum(0, 0u, 0, false);
  int left = 4;
  while (left > 0) {
    int largest = max(max(exponent.x, exponent.y), max(exponent.z, exponent.w));
    int next = exponent.x == largest ? 0 : exponent.y == largest ? 1 : exponent.z == largest ? 2 : 3;
    uint high, low;
    umulExtended(significand_of(a[next]), significand_of(b[next]), high, low);
    if (sign_of(sum) == 0)
      sum.exponent = largest;
    int shift = sum.exponent - largest;
    exponent[next] = -1;
    left--;
    if (log2_of(sum) + shift >= 61) {
      left = 0;
    } else {
      shift_left(sum, shift);
      add(sum, high, low, (a[next] ^ b[next]) >= SIGN_BIT);
    }
  }
  sum.complete = left == 0;
  return sum;
}

// sum / divisor in plain float32.
float quotient(const Sum sum, uint divisor) {
  bool negative = sum.high < 0;
  Sum magnitude = Sum(0, 0u, sum.exponent, true);
  add(magnitude, uint(sum.high), sum.low, negative);
  float value = float(magnitude.high) * 4294967296.0f + float(magnitude.low);
  float size = value / float(significand_of(divisor)) * power_of_two(sum.exponent - exponent_of(divisor) - 150);
  return negative != (divisor >= SIGN_BIT) ? -size : size;
}
