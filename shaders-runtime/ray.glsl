// A ray, prepared for walking. All t are those of the scaled direction.
struct Ray {
  vec3 origin;
  vec3 direction; // Scaled by a power of two, so that no product overflows.
  vec3 inverse;   // 1 / direction where the ray moves.
  bvec3 moves;    // False on an axis whose coordinate never changes.
  bvec3 falls;    // The coordinate falls.
  ivec3 heading;  // 1, -1 or 0.
  ivec3 ahead;    // 1 where the coordinate rises, else 0: picks the face of a cube that lies ahead.
};

// Where a ray is: the first cell not yet proved empty. Each step moves it by at least one cell, and never back, which
// bounds every loop by the volume's size.
struct Walk {
  ivec3 cell;   // In voxels; outside the volume before and after the walk.
  float t;      // Where the ray entered the cell.
  uint rgba;    // Of the voxel that was hit.
  uint lookups;
};

const float INFINITY = 1.0 / 0.0;

void count_lookup(inout Walk walk) {
  if (COUNT_LOOKUPS)
    walk.lookups++;
}

bool is_inside(const Walk walk) { return all(lessThan(uvec3(walk.cell), uvec3(VOLUME_SIZE))); }

// True for a cell of a grid of 2^log2_size cells.
bool in_grid(ivec3 cell, ivec3 log2_size) { return (cell >> log2_size) == ivec3(0); }

// The power of two that brings the largest component of a direction near 1.
float direction_scale(vec3 direction) {
  vec3 size = abs(direction);
  uint exponent = floatBitsToUint(max(max(size.x, size.y), size.z)) >> 23;
  return uintBitsToFloat((254u - clamp(exponent, 1u, 253u)) << 23);
}

Ray prepare_ray(vec3 origin, vec3 direction) {
  Ray ray;
  ray.origin = origin;
  ray.direction = direction;
  ray.inverse = vec3(1.0) / direction;
  // A component so small that its inverse overflows moves by less than a cell in any volume's width of the others.
  ray.moves = lessThan(abs(ray.inverse), vec3(INFINITY));
  ray.falls = lessThan(direction, vec3(0.0));
  ray.heading = ivec3(sign(direction)) * ivec3(ray.moves);
  ray.ahead = max(ray.heading, ivec3(0));
  return ray;
}
