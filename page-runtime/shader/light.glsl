// The light of voxc render: a sun, a sky, and what is behind everything.
const vec3 SUN_LIGHT = vec3(1.20, 1.11, 0.96);
const float PASSED_ON = 0.5; // What distant surfaces pass on of the sky's light.

vec3 to_linear(vec3 screen) {
  return mix(screen / 12.92, pow((screen + 0.055) / 1.055, vec3(2.4)), greaterThan(screen, vec3(0.04045)));
}

// Hues a golden section apart.
vec3 colour_of_label(uint label) {
  float least = label % 3u == 0u ? 0.25 : label % 3u == 1u ? 0.4 : 0.1;
  vec3 turn = fract(fract(float(label) * 0.618034) + vec3(0.0, 1.0, 2.0) / 3.0);
  return least + (0.95 - least) * clamp(abs(turn * 6.0 - 3.0) - 1.0, 0.0, 1.0);
}

vec3 colour_of_word(uint word) {
  if (IS_LABEL)
    return to_linear(colour_of_label(word));
  return to_linear(vec3(uvec3(word, word >> 8, word >> 16) & 255u) / 255.0);
}

vec3 sky_light(vec3 normal) { return mix(vec3(0.17, 0.155, 0.14), vec3(0.36, 0.41, 0.49), 0.5 + 0.5 * normal.y); }

// A direction about a normal, for two numbers from 0 to 1: as dense as the light from there counts.
vec3 sky_direction(vec3 normal, vec2 numbers) {
  float radius = sqrt(numbers.x);
  float angle = 6.2831853 * numbers.y;
  vec3 right = normalize(cross(abs(normal.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), normal));
  vec3 front = cross(normal, right);
  return right * (radius * cos(angle)) + front * (radius * sin(angle)) + normal * sqrt(max(1.0 - numbers.x, 1e-4));
}
