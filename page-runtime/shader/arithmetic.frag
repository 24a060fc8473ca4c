#version 300 es
// What this device makes of float32 numbers: the exact kernel stands on bounds of these roundings.
precision highp float;
precision highp int;
uniform highp usampler2D pairs;
layout(location = 0) out uvec4 sums;
layout(location = 1) out uvec4 others;

void main() {
  uvec4 bits = texelFetch(pairs, ivec2(gl_FragCoord.xy), 0);
  float a = uintBitsToFloat(bits.x), b = uintBitsToFloat(bits.y);
  sums = floatBitsToUint(vec4(a + b, a - b, a * b, 1.0 / b));
  others = uvec4(floatBitsToUint(floor(a)), floatBitsToUint(a), bits.x * bits.y, uint(int(floor(a))));
}
