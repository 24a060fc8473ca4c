// The t of a face, correctly rounded, in integers.

// An unsigned number of 64 bits.
struct Wide {
  uint high;
  uint low;
};

bool is_below(const Wide a, const Wide b) { return a.high < b.high || (a.high == b.high && a.low < b.low); }

Wide sum_of(const Wide a, const Wide b) {
  uint carry;
  uint low = uaddCarry(a.low, b.low, carry);
  return Wide(a.high + b.high + carry, low);
}

Wide difference_of(const Wide a, const Wide b) {
  uint borrow;
  uint low = usubBorrow(a.low, b.low, borrow);
  return Wide(a.high - b.high - borrow, low);
}

int log2_of(const Wide number) { return number.high != 0u ? 32 + findMSB(number.high) : findMSB(number.low); }

// number * 2^shift, shift in [-63, 63]. Bits that fall off the low end are told of; none falls off the high end.
Wide shifted(const Wide number, int shift, inout bool inexact) {
  int right = max(-shift, 0);
  int left = max(shift, 0);
  uint high = number.high;
  uint low = number.low;
  if (right >= 32) {
    inexact = inexact || low != 0u;
    low = high;
    high = 0u;
    right -= 32;
  } else if (left >= 32) {
    high = low;
    low = 0u;
    left -= 32;
  }
  if (right > 0) {
    inexact = inexact || (low & ((1u << right) - 1u)) != 0u;
    low = low >> right | high << (32 - right);
    high >>= right;
  } else if (left > 0) {
    high = high << left | low >> (32 - left);
    low <<= left;
  }
  return Wide(high, low);
}

// A number of 50 bits, times 2^exponent.
struct Distance {
  Wide number;
  int exponent;
  bool inexact; // The exact distance is a little more.
};

// |face - origin|, its leading 50 bits.
Distance distance_to(uint face, uint origin) {
  uint significand = significand_of(origin);
  int exponent = exponent_of(origin) - 150;
  // The larger of the two has its first bit at place 61, and so none below place 0.
  int top = max(face == 0u ? -1000 : findMSB(face), significand == 0u ? -1000 : exponent + findMSB(significand));
  Distance distance = Distance(Wide(0u, 0u), 0, false);
  Wide a = shifted(Wide(0u, face), clamp(61 - top, -63, 63), distance.inexact);
  Wide b = shifted(Wide(0u, significand), clamp(61 - top + exponent, -63, 63), distance.inexact);
  if (origin >= SIGN_BIT) {
    a = sum_of(a, b);
  } else {
    if (is_below(a, b))
      a = difference_of(b, a);
    else
      a = difference_of(a, b);
    if (distance.inexact) // What fell off was to be taken away.
      a = difference_of(a, Wide(0u, 1u));
  }
  int place = log2_of(a) - 49;
  distance.number = shifted(a, -place, distance.inexact);
  distance.exponent = top - 61 + place;
  return distance;
}

// value * 2^exponent of a value below 2^27, rounded to the nearest float32, ties to even; `inexact` if it is a little more.
uint rounded(uint value, int exponent, bool inexact) {
  int log2_value = findMSB(value) + exponent;
  if (log2_value > 127)
    return INFINITY_BITS;
  int drop = min(findMSB(value) - 23 + max(-126 - log2_value, 0), 31);
  uint kept = value >> drop;
  uint rest = value & ((1u << drop) - 1u);
  uint middle = 1u << (drop - 1);
  if (rest > middle || (rest == middle && (inexact || (kept & 1u) != 0u)))
    kept++;
  return min((uint(max(log2_value + 126, 0)) << 23) + kept, INFINITY_BITS);
}

// When the ray passes a face ahead of its origin: |face - origin| / |direction|, as bits of float32.
OUT_OF_LINE uint time_exactly(const Ray ray, int axis, int face) {
  Distance distance = distance_to(uint(face), ray.given_origin[axis]);
  if (distance.number.high == 0u)
    return 0u;
  uint divisor = significand_of(ray.given_direction[axis]);
  int shift = 23 - findMSB(divisor);
  divisor <<= shift;
  // The quotient, below 2^27, by an estimate that an exact remainder corrects: what float32 rounds leaves it wrong by less
  // than 100, so the remainder fits 32 bits; the quotient of that is wrong by 1 at most.
  float size = float(divisor);
  float estimate = (float(distance.number.high) * 4294967296.0f + float(distance.number.low)) / size;
  uint value = uint(estimate);
  uint high, low;
  umulExtended(value, divisor, high, low);
  int rest = int(distance.number.low - low);
  int more = int(floor(float(rest) / size));
  rest -= more * int(divisor);
  int last = rest < 0 ? -1 : rest >= int(divisor) ? 1 : 0;
  value += uint(more + last);
  rest -= last * int(divisor);
  int exponent = distance.exponent - (exponent_of(ray.given_direction[axis]) - 150 - shift);
  return rounded(value, exponent, distance.inexact || rest != 0);
}

// The same, by doubles. Not sure where what they get wrong could be rounded to another float32.
uint time_by_doubles(const Ray ray, int axis, int face, out bool sure) {
  double t = abs((double(face) - exactly(ray.given_origin[axis])) / exactly(ray.given_direction[axis]));
  double bound = t * double(1.0f / 562949953421312.0f); // Six roundings are 2^-50, and this is 2^-49.
  float least = float(t - bound);
  float most = float(t + bound);
  // By a power of two, as along an axis or a diagonal, nothing is rounded but the result.
  float origin = uintBitsToFloat(ray.given_origin[axis]);
  bool exact = (ray.given_direction[axis] & 0x7fffffu) == 0u && (abs(origin) > 1e-6f || origin == 0.0f);
  float value = exact ? float(t) : least;
  sure = ray.plain && (exact || least == most) && (value == 0.0f || (value > 1e-30f && value < 1e30f));
  return floatBitsToUint(value);
}

// The same, by sums of two float32 (pairs.glsl), which get less than 2^-43 of it wrong. Not sure where 2^-42 of it could be rounded to
// another float32. It is found for the scaled direction, so that it is that of the given one times a power of two.
uint time_by_pairs(const Ray ray, int axis, int face, out bool sure) {
  Pair way = exact_sum(float(face), -uintBitsToFloat(ray.given_origin[axis]));
  float speed = float(ray.direction[axis]);
  float inverse = float(ray.inverse[axis]);
  precise float first = way.high * inverse;
  precise float gone = first * speed;
  precise float left = ((way.high - gone) - lost_of(gone, first, speed)) + way.low;
  float more = left * inverse;
  float bound = abs(first) * (1.0f / 4398046511104.0f);
  precise float least = first + (more - bound);
  precise float most = first + (more + bound);
  float t = abs(least) * uintBitsToFloat(0x7f000000u - (longest_of(ray.given_direction) & INFINITY_BITS));
  bool is_in_range = abs(first) > 1e-9f && abs(first) < 1e12f && t > 1e-30f && t < 1e30f;
  sure = ray.is_moderate && (way.high == 0.0f || (is_in_range && least == most));
  return floatBitsToUint(way.high == 0.0f ? 0.0f : t);
}

// The same, by float32, whose three roundings may be wrong in the last places.
uint time_by_floats(const Ray ray, int axis, int face, out bool sure) {
  float t = abs((float(face) - uintBitsToFloat(ray.given_origin[axis])) / uintBitsToFloat(ray.given_direction[axis]));
  sure = ray.plain && t > 1e-30f && t < 1e30f;
  return floatBitsToUint(t);
}

// The same, as fast as it can be told. Where a device promises little of its arithmetic, integers tell it of every hit: a dispatch that
// does not resolve would defer each of them to one with it.
uint crossing_time(const Ray ray, int axis, int face, out bool sure) {
  sure = false;
  uint bits = 0u;
  if (IEEE)
    bits = time_by_doubles(ray, axis, face, sure);
  else if (EXACT && NEAREST)
    bits = time_by_pairs(ray, axis, face, sure);
  else if (!EXACT)
    bits = time_by_floats(ray, axis, face, sure);
  if ((EXACT_FALLBACK || (EXACT && !IEEE && !NEAREST)) && !sure) {
    bits = time_exactly(ray, axis, face);
    sure = true;
  }
  return bits;
}
