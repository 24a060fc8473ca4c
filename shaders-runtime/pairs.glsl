// What float32 loses of a sum or a product (compensated arithmetic; Dekker 1971, Knuth). It is a float32 itself where sums and products
// are rounded to nearest, and no number is so small that a device may not keep it.

// A number, as a sum of two of which the second is below what the first is rounded by.
struct Pair {
  float high;
  float low;
};

// The sum of two numbers, exactly.
Pair exact_sum(float a, float b) {
  precise float sum = a + b;
  precise float of_b = sum - a;
  precise float lost = (a - (sum - of_b)) + (b - of_b);
  return Pair(sum, lost);
}

// The first 12 bits of a number, rounded so that what is left of it has no more (Veltkamp 1968).
float upper_part(float number) {
  precise float scaled = number * 4097.0f;
  precise float rest = scaled - number;
  precise float upper = scaled - rest;
  return upper;
}

// What is lost of a product of two numbers, exactly.
float lost_of(float product, float a, float b) {
  if (REFINES) // There a multiplication is fused with an addition.
    return fma(a, b, -product);
  float upper_a = upper_part(a);
  float upper_b = upper_part(b);
  precise float lower_a = a - upper_a;
  precise float lower_b = b - upper_b;
  precise float lost = ((upper_a * upper_b - product) + upper_a * lower_b + lower_a * upper_b) + lower_a * lower_b;
  return lost;
}
