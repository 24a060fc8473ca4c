// From light to what a screen shows; a picture of fewer pixels is blurred.
vec3 backdrop(vec3 direction) {
  float amount = min(abs(direction.y) * 1.3, 1.0);
  vec3 end = direction.y < 0.0 ? vec3(0.26, 0.27, 0.29) : vec3(0.20, 0.29, 0.42);
  return mix(vec3(0.52, 0.58, 0.64), end, amount * amount * (3.0 - 2.0 * amount));
}

// What is brighter than a screen can be grows white slowly.
vec3 compressed(vec3 light) {
  const float SHOULDER = 0.7, REST = 1.0 - SHOULDER;
  float peak = max(max(light.x, light.y), light.z);
  if (peak <= SHOULDER)
    return light;
  float lower = 1.0 - REST * REST / (peak - SHOULDER + REST);
  float excess = peak - lower;
  return mix(light * (lower / peak), vec3(lower), excess / (excess + 3.0));
}

// How much of the sky a pixel sees. Where rays were few, pixels of its surface tell what they have found, a square of four by four.
float seen_of_sky(ivec2 at, uint first, float seen) {
  float hits = float(first & 511u);
  if (given.samples >= 32.0)
    return seen / hits;
  vec3 point = point_of(at, first);
  float sum = 0.0, count = 0.0;
  for (int i = 0; i < 16; i++) {
    ivec2 place = at + ivec2(i & 3, i >> 2) - ivec2(2, 1);
    if (any(notEqual(place, clamp(place, ivec2(0), given.size - 1))))
      continue;
    uint other = texelFetch(sun_light, place, 0).w;
    vec3 apart = point_of(place, other) - point;
    float off = abs(apart[min(int(first >> 10 & 3u), 2)]);
    bool is_kin = given.is_smooth != 0 ? length(apart) < 6.0 : (other >> 9 & 7u) == (first >> 9 & 7u) && off < 1.5 + 0.35 * length(apart);
    if (other != 0u && is_kin) {
      sum += uintBitsToFloat(texelFetch(sky_light, place, 0).w);
      count += float(other & 511u);
    }
  }
  return sum / count;
}

float samples_of(ivec2 at) {
  bool has_one_more = given.is_partial != 0 && texelFetch(told, at, 0).x < 0x80000000u;
  return given.samples + float(has_one_more);
}

vec3 pixel(ivec2 place, vec3 behind) {
  ivec2 at = clamp(place, ivec2(0), given.size - 1);
  uvec4 sun = texelFetch(sun_light, at, 0);
  float hits = float(sun.w & 511u);
  if (hits == 0.0)
    return sun.w == 0u ? behind : uintBitsToFloat(sun.xyz); // A sketch.
  vec4 sky = uintBitsToFloat(texelFetch(sky_light, at, 0));
  vec3 light = (uintBitsToFloat(sun.xyz) + sky.xyz * seen_of_sky(at, sun.w, sky.w)) / hits;
  return mix(behind, compressed(light * given.exposure), hits / samples_of(at));
}

// The colour of a place of the canvas, in pixels from its lower left corner.
vec3 colour_at(vec2 pixels) {
  vec2 place = pixels / given.canvas;
  vec3 behind = backdrop(way(2.0 * place - 1.0));
  vec2 at = place * vec2(given.size) - 0.5;
  ivec2 low = ivec2(floor(at + 0.001));
  vec2 part = max(at - vec2(low), 0.0);
  vec3 linear = pixel(low, behind);
  if (max(part.x, part.y) > 0.001) {
    vec3 lower = mix(linear, pixel(low + ivec2(1, 0), behind), part.x);
    vec3 upper = mix(pixel(low + ivec2(0, 1), behind), pixel(low + ivec2(1, 1), behind), part.x);
    linear = mix(lower, upper, part.y);
  }
  linear = clamp(linear, 0.0, 1.0);
  return mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, greaterThan(linear, vec3(0.0031308)));
}
