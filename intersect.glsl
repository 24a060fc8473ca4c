#version 460
// intersect.glsl: first hits of rays with volumes of the format R(2, 2, 2) D(2, 2, 2, 4) S(2) G(3).

// Voxels along each axis.
const ivec3 VOLUME_SIZE = ivec3(512, 512, 512);

layout(local_size_x = 64) in;

// Count the lookups of each ray; off, it costs nothing.
layout(constant_id = 0) const bool COUNT_LOOKUPS = false;

// Six floats a ray: origin, direction.
layout(std430, set = 0, binding = 0) readonly restrict buffer Rays { float ray_floats[]; };
// Six words a hit: voxel, rgba, t, lookups.
layout(std430, set = 0, binding = 1) restrict buffer Hits { uint hit_words[]; };
// The rays of this dispatch; `resumes` is 1 for those that an earlier dispatch left unfinished.
layout(push_constant) uniform Tile { uint first_ray; uint ray_count; uint resumes; };

// The volume's words lie in one storage buffer.
layout(std430, set = 0, binding = 2) readonly restrict buffer Words { uint words[]; };

uint load_word(uint offset) { return words[offset]; }

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

// Steps in plain float32: wrong only by rounding at a cell's boundary. Cells are half-open, so where several
// coordinates cross a face at one t, rising ones change cell first, falling ones just after.

// The next change of cell.
struct Crossing {
  float t;
  ivec3 step;  // The change, a cell at most on each axis.
  bool rising; // Only rising coordinates change: those that fall may still stand on a boundary.
};

// How the ray leaves the cube of `side` voxels at `corner`.
Crossing leave_cube(const Ray ray, ivec3 corner, int side) {
  vec3 face = vec3(corner + ray.ahead * side);
  vec3 t = mix(vec3(INFINITY), (face - ray.origin) * ray.inverse, ray.moves);
  Crossing crossing;
  crossing.t = min(min(t.x, t.y), t.z);
  ivec3 crossed = ivec3(equal(t, vec3(crossing.t)));
  ivec3 risen = crossed * ray.ahead;
  crossing.rising = risen != ivec3(0);
  crossing.step = crossing.rising ? risen : crossed * ray.heading;
  return crossing;
}

// The voxel coordinates of the point at t, before rounding errors are bounded.
vec3 cell_at(const Ray ray, float t, bool rising) {
  vec3 point = ray.origin + t * ray.direction;
  vec3 cell = floor(point);
  return rising ? cell : mix(cell, ceil(point) - 1.0, ray.falls);
}

// Puts the walk into the cube of `side` voxels at `corner` that a crossing leads to.
void land(const Ray ray, inout Walk walk, const Crossing crossing, ivec3 corner, int side) {
  ivec3 last = corner + (side - 1);
  ivec3 least = mix(max(corner, walk.cell), corner, ray.falls);
  ivec3 most = mix(min(last, walk.cell), last, greaterThan(ray.ahead, ivec3(0)));
  // An axis that has just been crossed is on its face, whatever rounding says.
  least = mix(least, last, lessThan(crossing.step, ivec3(0)));
  most = mix(most, corner, greaterThan(crossing.step, ivec3(0)));
  vec3 cell = clamp(cell_at(ray, crossing.t, crossing.rising), vec3(least), vec3(most));
  walk.cell = ivec3(cell);
  walk.t = max(walk.t, crossing.t);
}

// Steps over the empty cube of `side` voxels at `corner`.
void step_over(const Ray ray, inout Walk walk, ivec3 corner, int side) {
  Crossing crossing = leave_cube(ray, corner, side);
  if (side == 1) {
    walk.cell = corner + crossing.step;
    walk.t = max(walk.t, crossing.t);
  } else {
    land(ray, walk, crossing, corner + crossing.step * side, side);
  }
}

// Steps from an empty cell of a grid to the first cell whose L1 distance is not below `distance`, or that lies outside
// the grid; no lookup is needed on the way.
void march(const Ray ray, inout Walk walk, ivec3 low, ivec3 cell, ivec3 log2_size, int log2_cell, uint distance) {
  int left = int(distance);
  Crossing crossing;
  // The condition stands at the head: Mesa 22.3's llvmpipe lets lanes that leave a loop further down run on.
  while (left > 0) {
    crossing = leave_cube(ray, low + (cell << log2_cell), 1 << log2_cell);
    cell += crossing.step;
    ivec3 moved = abs(crossing.step);
    left = in_grid(cell, log2_size) ? left - (moved.x + moved.y + moved.z) : 0;
  }
  land(ray, walk, crossing, low + (cell << log2_cell), 1 << log2_cell);
}

// Puts the walk into the first cell of [0, size)^3 on the ray; false if there is none.
bool enter_volume(const Ray ray, inout Walk walk, ivec3 size) {
  vec3 upper = vec3(size);
  bvec3 rises = greaterThan(ray.ahead, ivec3(0));
  bvec3 below = lessThan(ray.origin, vec3(0.0));
  bvec3 above = greaterThanEqual(ray.origin, upper);
  if (any(mix(mix(above, below, ray.falls), bvec3(ivec3(below) | ivec3(above)), not(ray.moves))))
    return false;

  bvec3 outside = mix(below, above, ray.falls);
  vec3 t_in = mix(vec3(0.0), (mix(vec3(0.0), upper, ray.falls) - ray.origin) * ray.inverse, outside);
  vec3 t_out = mix(vec3(INFINITY), (mix(vec3(0.0), upper, rises) - ray.origin) * ray.inverse, ray.moves);
  float t = max(max(t_in.x, t_in.y), t_in.z);
  if (!(t < INFINITY))
    return false;

  // A coordinate that falls into the volume is there just after t, when one that is to leave at t has left.
  bvec3 entered = bvec3(ivec3(outside) * ivec3(equal(t_in, vec3(t))));
  bool rising = !any(bvec3(ivec3(entered) * ivec3(ray.falls)));
  bvec3 left = lessThanEqual(t_out, vec3(t));
  if (rising)
    left = mix(left, lessThan(t_out, vec3(t)), ray.falls);
  if (any(left))
    return false;

  vec3 cell = clamp(cell_at(ray, t, rising), vec3(0.0), upper - 1.0);
  cell = mix(cell, mix(vec3(0.0), upper - 1.0, ray.falls), entered);
  walk.cell = ivec3(cell);
  walk.t = t;
  return true;
}

// A single voxel: the walk has arrived.
bool intersect_voxel(const Ray ray, inout Walk walk, uint rgba, ivec3 low) {
  walk.rgba = rgba;
  return true;
}

// A node of a DAG is [masks, pointers to the children that are not empty...].
// Gives child x + 2y + 4z of a node, or 0 if it is empty.
uint svdag_child(uint node, int child, out bool leaf) {
  uint masks = load_word(node);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  return load_word(node + 1u + uint(bitCount(masks & ((1u << child) - 1u))));
}

// Which child of a node the cell lies in; the child covers 2^height cells a side.
int child_index(ivec3 cell, int height) {
  ivec3 bits = (cell >> height) & 1;
  return bits.x | bits.y << 1 | bits.z << 2;
}

// Level 4: svdag, 8 x 8 x 8 cells of 1 voxel a side.
const int LEVEL_4_DEPTH = 3;
const int LEVEL_4_LOG2_CELL = 0;

// path[h] is the node of 2^h cells a side around the cell: a step climbs only to the ancestor of the old and the new.
bool intersect_level_4(const Ray ray, inout Walk walk, uint root, ivec3 low) {
  uint path[LEVEL_4_DEPTH + 1];
  path[LEVEL_4_DEPTH] = root;
  int height = LEVEL_4_DEPTH;
  ivec3 cell = (walk.cell - low) >> LEVEL_4_LOG2_CELL;
  for (;;) {
    // Down to the leaf, or the empty child, of 2^side cells a side around the cell.
    count_lookup(walk);
    uint node = path[height];
    int side = height;
    bool leaf = false;
    while (node != 0u && !leaf) {
      path[side] = node;
      side--;
      node = svdag_child(node, child_index(cell, side), leaf);
    }
    if (node == 0u)
      step_over(ray, walk, low + ((cell >> side) << (side + LEVEL_4_LOG2_CELL)), 1 << (side + LEVEL_4_LOG2_CELL));
    else if (leaf && intersect_voxel(ray, walk, load_word(node), low + (cell << LEVEL_4_LOG2_CELL)))
      return true;

    ivec3 next = (walk.cell - low) >> LEVEL_4_LOG2_CELL;
    if (!in_grid(next, ivec3(LEVEL_4_DEPTH)))
      return false;
    ivec3 changed = cell ^ next;
    height = max(side, findMSB(changed.x | changed.y | changed.z)) + 1;
    cell = next;
  }
}

// A node of an octree is [first child, masks]; its children that are not empty stand together, two words each.
// Gives child x + 2y + 4z of a node, or 0 if it is empty.
uint svo_child(uint node, int child, out bool leaf) {
  uint masks = load_word(node + 1u);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  return load_word(node) + 2u * uint(bitCount(masks & ((1u << child) - 1u)));
}

// Level 3: svo, 4 x 4 x 4 cells of 8 voxels a side.
const int LEVEL_3_DEPTH = 2;
const int LEVEL_3_LOG2_CELL = 3;

// path[h] is the node of 2^h cells a side around the cell: a step climbs only to the ancestor of the old and the new.
bool intersect_level_3(const Ray ray, inout Walk walk, uint root, ivec3 low) {
  uint path[LEVEL_3_DEPTH + 1];
  path[LEVEL_3_DEPTH] = root;
  int height = LEVEL_3_DEPTH;
  ivec3 cell = (walk.cell - low) >> LEVEL_3_LOG2_CELL;
  for (;;) {
    // Down to the leaf, or the empty child, of 2^side cells a side around the cell.
    count_lookup(walk);
    uint node = path[height];
    int side = height;
    bool leaf = false;
    while (node != 0u && !leaf) {
      path[side] = node;
      side--;
      node = svo_child(node, child_index(cell, side), leaf);
    }
    if (node == 0u)
      step_over(ray, walk, low + ((cell >> side) << (side + LEVEL_3_LOG2_CELL)), 1 << (side + LEVEL_3_LOG2_CELL));
    else if (leaf && intersect_level_4(ray, walk, load_word(node), low + (cell << LEVEL_3_LOG2_CELL)))
      return true;

    ivec3 next = (walk.cell - low) >> LEVEL_3_LOG2_CELL;
    if (!in_grid(next, ivec3(LEVEL_3_DEPTH)))
      return false;
    ivec3 changed = cell ^ next;
    height = max(side, findMSB(changed.x | changed.y | changed.z)) + 1;
    cell = next;
  }
}

// A distance field stores two words a cell, x fastest, then y, then z: terminating integer, distance.
uint distance_entry(uint grid, ivec3 cell, ivec3 log2_size) {
  return grid + 2u * uint(cell.x + ((cell.y + (cell.z << log2_size.y)) << log2_size.x));
}

// Level 2: distance, 4 x 4 x 4 cells of 32 voxels a side.
const ivec3 LEVEL_2_LOG2_SIZE = ivec3(2, 2, 2);
const int LEVEL_2_LOG2_CELL = 5;

bool intersect_level_2(const Ray ray, inout Walk walk, uint grid, ivec3 low) {
  ivec3 cell = (walk.cell - low) >> LEVEL_2_LOG2_CELL;
  while (in_grid(cell, LEVEL_2_LOG2_SIZE)) {
    count_lookup(walk);
    uint entry = distance_entry(grid, cell, LEVEL_2_LOG2_SIZE);
    uint value = load_word(entry);
    if (value == 0u)
      march(ray, walk, low, cell, LEVEL_2_LOG2_SIZE, LEVEL_2_LOG2_CELL, load_word(entry + 1u));
    else if (intersect_level_3(ray, walk, value, low + (cell << LEVEL_2_LOG2_CELL)))
      return true;
    cell = (walk.cell - low) >> LEVEL_2_LOG2_CELL;
  }
  return false;
}

// A raw grid stores its cells x fastest, then y, then z.
uint raw_cell(uint grid, ivec3 cell, ivec3 log2_size) {
  return load_word(grid + uint(cell.x + ((cell.y + (cell.z << log2_size.y)) << log2_size.x)));
}

// Level 1: raw, 4 x 4 x 4 cells of 128 voxels a side.
const ivec3 LEVEL_1_LOG2_SIZE = ivec3(2, 2, 2);
const int LEVEL_1_LOG2_CELL = 7;

bool intersect_level_1(const Ray ray, inout Walk walk, uint grid, ivec3 low) {
  ivec3 cell = (walk.cell - low) >> LEVEL_1_LOG2_CELL;
  while (in_grid(cell, LEVEL_1_LOG2_SIZE)) {
    count_lookup(walk);
    uint value = raw_cell(grid, cell, LEVEL_1_LOG2_SIZE);
    ivec3 corner = low + (cell << LEVEL_1_LOG2_CELL);
    if (value == 0u)
      step_over(ray, walk, corner, 1 << LEVEL_1_LOG2_CELL);
    else if (intersect_level_2(ray, walk, value, corner))
      return true;
    cell = (walk.cell - low) >> LEVEL_1_LOG2_CELL;
  }
  return false;
}

// The whole volume: word 0 leads to level 1, unless the volume is empty. A walk that starts outside is first put into it.
bool intersect_root(const Ray ray, inout Walk walk) {
  uint root = load_word(0u);
  if (root == 0u || (!is_inside(walk) && !enter_volume(ray, walk, VOLUME_SIZE)))
    return false;
  return intersect_level_1(ray, walk, root, ivec3(0));
}

bool is_finite(vec3 v) { return all(lessThan(abs(v), vec3(INFINITY))); }

// Traces one ray from where its walk is; walk.t is that of the ray as it was given.
bool trace(vec3 origin, vec3 direction, inout Walk walk) {
  if (!is_finite(origin) || !is_finite(direction))
    return false;
  float scale = direction_scale(direction);
  Ray ray = prepare_ray(origin, direction * scale);
  // A ray that goes nowhere can hit its own cell alone: let it go anywhere and take no later hit.
  bool stands = !any(ray.moves);
  if (stands)
    ray = prepare_ray(origin, vec3(1.0, 0.0, 0.0));
  walk.t /= scale;
  bool hit = intersect_root(ray, walk);
  if (stands && walk.t > 0.0) {
    hit = false;
    walk.cell = ivec3(-1);
  }
  walk.t *= scale;
  return hit;
}

vec3 load_vector(uint at) { return vec3(ray_floats[at], ray_floats[at + 1u], ray_floats[at + 2u]); }

// A hit is its voxel. A miss is -1. A walk that ended inside the volume without a hit was cut short by the device, which
// may limit how long a loop runs (Mesa's llvmpipe: 65535 turns in all); it is kept as -2 - cell, to be resumed.
void store(uint at, const Walk walk, bool hit) {
  bool unfinished = !hit && is_inside(walk);
  ivec3 voxel = hit ? walk.cell : unfinished ? -2 - walk.cell : ivec3(-1);
  hit_words[at] = uint(voxel.x);
  hit_words[at + 1u] = uint(voxel.y);
  hit_words[at + 2u] = uint(voxel.z);
  hit_words[at + 3u] = hit ? walk.rgba : 0u;
  hit_words[at + 4u] = hit || unfinished ? floatBitsToUint(walk.t) : 0u;
  hit_words[at + 5u] = walk.lookups;
}

void main() {
  if (gl_GlobalInvocationID.x >= ray_count)
    return;
  uint at = 6u * (first_ray + gl_GlobalInvocationID.x);
  Walk walk = Walk(ivec3(-1), 0.0, 0u, 0u);
  if (resumes != 0u) {
    walk.cell = -2 - ivec3(hit_words[at], hit_words[at + 1u], hit_words[at + 2u]);
    if (!is_inside(walk))
      return;
    walk.t = uintBitsToFloat(hit_words[at + 4u]);
    walk.lookups = hit_words[at + 5u];
  }
  bool hit = trace(load_vector(at), load_vector(at + 3u), walk);
  store(at, walk, hit);
}
