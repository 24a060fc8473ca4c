// The directions of smooth surfaces: that in which the voxels around a pixel, which its neighbours have met, spread least.

const int REACH = 4;

// A symmetric matrix: its diagonal, and beside that the elements of y and z, of z and x, of x and y.
struct Spread {
  vec3 own;
  vec3 mixed;
};

ivec3 voxel_of(ivec2 at, uint first) {
  vec3 into = vec3(0.0);
  uint face = first >> 9 & 7u;
  if (face < 6u)
    into[face >> 1] = (face & 1u) == 0u ? 0.5 : -0.5;
  return ivec3(floor((given.eye + point_of(at, first)) / SPACING + into));
}

// Its least eigenvalue and the next, by the cosine formula.
vec2 least_of(const Spread spread) {
  float mean = (spread.own.x + spread.own.y + spread.own.z) / 3.0;
  vec3 own = spread.own - mean;
  vec3 mixed = spread.mixed;
  float p = sqrt((dot(own, own) + 2.0 * dot(mixed, mixed)) / 6.0);
  if (p < 1e-6)
    return vec2(mean);
  float det = own.x * own.y * own.z + 2.0 * mixed.x * mixed.y * mixed.z - dot(own, mixed * mixed);
  float angle = acos(clamp(det / (2.0 * p * p * p), -1.0, 1.0)) / 3.0;
  float low = mean + 2.0 * p * cos(angle + 2.0943951);
  return vec2(low, 3.0 * mean - low - (mean + 2.0 * p * cos(angle)));
}

// The direction across its rows, where it has a rank of two.
vec3 across(const Spread spread) {
  vec3 x = vec3(spread.own.x, spread.mixed.z, spread.mixed.y);
  vec3 y = vec3(spread.mixed.z, spread.own.y, spread.mixed.x);
  vec3 z = vec3(spread.mixed.y, spread.mixed.x, spread.own.z);
  vec3 best = cross(x, y);
  vec3 other = cross(y, z);
  best = dot(other, other) > dot(best, best) ? other : best;
  other = cross(z, x);
  best = dot(other, other) > dot(best, best) ? other : best;
  return dot(best, best) > 0.0 ? normalize(best) : vec3(0.0);
}

// The normal of the surface around a voxel, towards the eye; 0 where its voxels spread evenly, or are too few to tell.
vec3 surface_normal(ivec2 pixel, ivec3 voxel, float t, vec3 direction) {
  float far = given.is_parallel != 0 ? 1.0 : max(t, 1.0);
  float step = max(float(given.size.y) / (2.0 * length(given.up) * far), 1.0); // Pixels a voxel.
  float count = 0.0;
  vec3 sum = vec3(0.0);
  Spread squares = Spread(vec3(0.0), vec3(0.0));
  for (int i = -REACH; i <= REACH; i++)
    for (int j = -REACH; j <= REACH; j++) {
      ivec2 at = pixel + ivec2(round(vec2(float(i), float(j)) * step));
      if (any(notEqual(at, clamp(at, ivec2(0), given.size - 1))))
        continue;
      uint first = texelFetch(before_sun, at, 0).w;
      vec3 offset = vec3(voxel_of(at, first) - voxel);
      vec3 apart = abs(offset);
      if (first == 0u || max(max(apart.x, apart.y), apart.z) > float(REACH))
        continue;
      float weight = exp(-0.11 * dot(offset, offset));
      count += weight;
      sum += weight * offset;
      squares.own += weight * offset * offset;
      squares.mixed += weight * offset.yzx * offset.zxy;
    }
  if (count < 3.0)
    return vec3(0.0);
  sum /= count;
  Spread spread = Spread(squares.own / count - sum * sum, squares.mixed / count - sum.yzx * sum.zxy);
  vec2 least = least_of(spread);
  if (least.x > 0.85 * least.y)
    return vec3(0.0);
  vec3 normal = across(Spread(spread.own - least.x, spread.mixed));
  return dot(normal, direction) < 0.0 ? normal : -normal;
}
