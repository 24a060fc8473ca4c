// The directions of smooth surfaces: that in which the voxels around a pixel, which its neighbours have met, spread least.

uniform highp usampler2D before_sun; // The samples so far, or the sketch.
uniform ivec2 size;

const int REACH = 4;

// Where the first ray of a pixel has met the volume, from the eye, and by which face.
vec3 point_of(ivec2 at, uint first) {
  vec2 place = (vec2(at) + 0.5) / vec2(size) * 2.0 - 1.0;
  return aside(place) + way(place) * uintBitsToFloat(first & ~0xfffu);
}

ivec3 voxel_of(ivec2 at, uint first) {
  vec3 into = vec3(0.0);
  uint face = first >> 9 & 7u;
  if (face < 6u)
    into[face >> 1] = (face & 1u) == 0u ? 0.5 : -0.5;
  return ivec3(floor((eye + point_of(at, first)) / SPACING + into));
}

// The least eigenvalue of a symmetric matrix and the next, by the cosine formula.
vec2 least_of(mat3 m) {
  float mean = (m[0][0] + m[1][1] + m[2][2]) / 3.0;
  mat3 apart = m - mat3(mean);
  float p = sqrt((dot(apart[0], apart[0]) + dot(apart[1], apart[1]) + dot(apart[2], apart[2])) / 6.0);
  if (p < 1e-6)
    return vec2(mean);
  float angle = acos(clamp(determinant(apart) / (2.0 * p * p * p), -1.0, 1.0)) / 3.0;
  float low = mean + 2.0 * p * cos(angle + 2.0943951);
  return vec2(low, 3.0 * mean - low - (mean + 2.0 * p * cos(angle)));
}

// The direction across the rows of a matrix of rank two.
vec3 across(mat3 m) {
  vec3 a = cross(m[0], m[1]), b = cross(m[1], m[2]), c = cross(m[2], m[0]);
  vec3 best = dot(a, a) > dot(b, b) ? a : b;
  best = dot(c, c) > dot(best, best) ? c : best;
  return dot(best, best) > 0.0 ? normalize(best) : vec3(0.0);
}

// The normal of the surface around a voxel, towards the eye; 0 where its voxels spread evenly, or are too few to tell.
vec3 surface_normal(ivec2 pixel, ivec3 voxel, float t, vec3 direction) {
  float step = max(float(size.y) / (2.0 * length(up) * (is_parallel ? 1.0 : max(t, 1.0))), 1.0); // Pixels a voxel.
  float count = 0.0;
  vec3 sum = vec3(0.0);
  mat3 squares = mat3(0.0);
  for (int i = -REACH; i <= REACH; i++)
    for (int j = -REACH; j <= REACH; j++) {
      ivec2 at = pixel + ivec2(round(vec2(i, j) * step));
      if (any(notEqual(at, clamp(at, ivec2(0), size - 1))))
        continue;
      uint first = texelFetch(before_sun, at, 0).w;
      vec3 offset = vec3(voxel_of(at, first) - voxel);
      vec3 far = abs(offset);
      if (first == 0u || max(max(far.x, far.y), far.z) > float(REACH))
        continue;
      float weight = exp(-0.11 * dot(offset, offset));
      count += weight;
      sum += weight * offset;
      squares += weight * outerProduct(offset, offset);
    }
  if (count < 3.0)
    return vec3(0.0);
  sum /= count;
  mat3 spread = squares / count - outerProduct(sum, sum);
  vec2 least = least_of(spread);
  vec3 normal = least.x > 0.85 * least.y ? vec3(0.0) : across(spread - mat3(least.x));
  return dot(normal, direction) < 0.0 ? normal : -normal;
}
