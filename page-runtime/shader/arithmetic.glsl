// What this device makes of float32 numbers: the exact kernel stands on bounds of these roundings.
Texels texels_at(ivec2 at) {
  uvec4 bits = texelFetch(pairs, at, 0);
  float a = uintBitsToFloat(bits.x);
  float b = uintBitsToFloat(bits.y);
  return Texels(floatBitsToUint(vec4(a + b, a - b, a * b, 1.0 / b)),
                uvec4(floatBitsToUint(floor(a)), floatBitsToUint(a), bits.x * bits.y, uint(int(floor(a)))));
}
