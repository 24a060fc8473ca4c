#version 300 es
// From light to what a screen shows; a picture of fewer pixels is made smooth.
precision highp float;
precision highp int;
uniform highp usampler2D light;
uniform float samples;
uniform float exposure;
uniform vec2 canvas;
uniform vec3 front;
uniform vec3 right;
uniform vec3 up;
out vec4 shown;

vec3 backdrop(vec3 direction) {
  float amount = min(abs(normalize(direction).y) * 1.3, 1.0);
  vec3 end = direction.y < 0.0 ? vec3(0.26, 0.27, 0.29) : vec3(0.20, 0.29, 0.42);
  return mix(vec3(0.52, 0.58, 0.64), end, amount * amount * (3.0 - 2.0 * amount));
}

// What is brighter than a screen can be grows white slowly.
vec3 compressed(vec3 light) {
  const float SHOULDER = 0.7, REST = 1.0 - SHOULDER;
  float peak = max(max(light.r, light.g), light.b);
  if (peak <= SHOULDER)
    return light;
  float lower = 1.0 - REST * REST / (peak - SHOULDER + REST);
  float excess = peak - lower;
  return mix(light * (lower / peak), vec3(lower), excess / (excess + 3.0));
}

vec3 pixel(ivec2 at, vec3 behind) {
  vec4 sum = uintBitsToFloat(texelFetch(light, clamp(at, ivec2(0), textureSize(light, 0) - 1), 0));
  float share = sum.a / samples;
  vec3 colour = sum.a > 0.0 ? compressed(sum.rgb * (exposure / sum.a)) * share : vec3(0.0);
  return colour + behind * (1.0 - share);
}

void main() {
  vec2 place = gl_FragCoord.xy / canvas;
  vec3 behind = backdrop(front + right * (2.0 * place.x - 1.0) + up * (2.0 * place.y - 1.0));
  vec2 at = place * vec2(textureSize(light, 0)) - 0.5;
  ivec2 low = ivec2(floor(at));
  vec2 part = at - floor(at);
  vec3 lower = mix(pixel(low, behind), pixel(low + ivec2(1, 0), behind), part.x);
  vec3 upper = mix(pixel(low + ivec2(0, 1), behind), pixel(low + ivec2(1, 1), behind), part.x);
  vec3 linear = clamp(mix(lower, upper, part.y), 0.0, 1.0);
  shown = vec4(mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, greaterThan(linear, vec3(0.0031308))), 1.0);
}
