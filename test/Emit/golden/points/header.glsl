// ---- The format: D(4, 4, 4, 5) G(4) ----

// Which child of a node a place lies in, counted in children.
int voxc_d4_4_4_5_g4_child_index(ivec3 place) {
  ivec3 bits = place & 1;
  return bits.x | bits.y << 1 | bits.z << 2;
}

// Level 2: svdag, 16 x 16 x 16 cells of 1 voxel a side.
const int voxc_d4_4_4_5_g4_LEVEL_2_DEPTH = 4;
const int voxc_d4_4_4_5_g4_LEVEL_2_LOG2_CELL = 0;
const int voxc_d4_4_4_5_g4_LEVEL_2_LOG2_SIDE = 4;

// A node is [masks, slots of its children...]: a bit for each child that is not empty, one for each that is a leaf, and
// slots of those that are not empty or, where all leaves have one value, that are neither empty nor leaves. Gives the
// child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
uint voxc_d4_4_4_5_g4_child_level_2(VOXC_VOLUME volume, uint node, ivec3 cell, int height, out bool leaf) {
  int child = voxc_d4_4_4_5_g4_child_index(cell >> height);
  uint masks = voxc_d4_4_4_5_g4_load_word(volume, node);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  return voxc_d4_4_4_5_g4_load_word(volume, node + 1u + uint(bitCount(masks & ((1u << child) - 1u))));
}

// path[i] is the node i layers above the cells around the traversal's cell: a step climbs only to the ancestor of the
// old cell and the new.
bool voxc_d4_4_4_5_g4_intersect_level_2(VOXC_VOLUME volume, const voxc_d4_4_4_5_g4_Ray ray,
    inout voxc_d4_4_4_5_g4_Traversal traversal, uint root) {
  uint path[voxc_d4_4_4_5_g4_LEVEL_2_DEPTH + 1];
  path[voxc_d4_4_4_5_g4_LEVEL_2_DEPTH] = root;
  int top = voxc_d4_4_4_5_g4_LEVEL_2_DEPTH;
  for (;;) {
    ivec3 cell = traversal.cell >> voxc_d4_4_4_5_g4_LEVEL_2_LOG2_CELL;
    uint node = path[top];
    int layer = top;
    bool leaf = false;
    while (node != 0u && !leaf) {
      path[layer] = node;
      layer--;
      node = voxc_d4_4_4_5_g4_child_level_2(volume, node, cell, layer, leaf);
    }
    ivec3 before = traversal.cell;
    if (node == 0u)
      voxc_d4_4_4_5_g4_step_over(ray, traversal, voxc_d4_4_4_5_g4_LEVEL_2_LOG2_CELL + layer);
    else if (leaf && voxc_d4_4_4_5_g4_intersect_voxel(traversal, node))
      return true;
    ivec3 changed = before ^ traversal.cell;
    int highest = findMSB(uint(changed.x | changed.y | changed.z));
    if (highest >= voxc_d4_4_4_5_g4_LEVEL_2_LOG2_SIDE)
      return false;
    top = max(layer, highest - voxc_d4_4_4_5_g4_LEVEL_2_LOG2_CELL) + 1;
  }
}

// Level 1: distance, 16 x 16 x 16 cells of 16 voxels a side.
const ivec3 voxc_d4_4_4_5_g4_LEVEL_1_LOG2_SIZE = ivec3(4, 4, 4);
const int voxc_d4_4_4_5_g4_LEVEL_1_LOG2_CELL = 4;

// A grid has a slot a cell, x fastest, then y, then z.
// The place of a cell's slot: in that granule, where references count granules.
uint voxc_d4_4_4_5_g4_slot_level_1(uint grid, ivec3 cell) {
  ivec3 at = cell;
  return grid + 2u * uint(at.x + ((at.y
      + (at.z << voxc_d4_4_4_5_g4_LEVEL_1_LOG2_SIZE.y)) << voxc_d4_4_4_5_g4_LEVEL_1_LOG2_SIZE.x));
}

// The value of a cell, or 0 if it is empty; `span` then counts the cells of its distance.
uint voxc_d4_4_4_5_g4_look_up_level_1(VOXC_VOLUME volume, uint grid, ivec3 cell,
    inout voxc_d4_4_4_5_g4_EmptySpan span) {
  uint slot = voxc_d4_4_4_5_g4_slot_level_1(grid, cell);
  uint word = voxc_d4_4_4_5_g4_load_word(volume, slot);
  // The distance stands behind the value.
  uint skip = word == 0u ? voxc_d4_4_4_5_g4_load_word(volume, slot + 1u) : 0u;
  span.count = int(skip & 0x7fffffffu);
  return word;
}

// Whether a traversal is still in the sub-volume in which it began.
bool voxc_d4_4_4_5_g4_within_level_1(ivec3 cell) { return voxc_d4_4_4_5_g4_is_in_volume(cell); }

// Steps from an empty cell to the first whose L1 distance is not below `left`, or that lies outside the sub-volume; no
// lookup is needed on the way.
void voxc_d4_4_4_5_g4_march_level_1(const voxc_d4_4_4_5_g4_Ray ray, inout voxc_d4_4_4_5_g4_Traversal traversal,
    int left) {
  const int side = 1 << voxc_d4_4_4_5_g4_LEVEL_1_LOG2_CELL;
  ivec3 face = voxc_d4_4_4_5_g4_corner_of(traversal.cell, voxc_d4_4_4_5_g4_LEVEL_1_LOG2_CELL) + (ray.ahead & side);
  ivec3 corner = face; // `left` is at least 1, which compilers cannot know.
  voxc_d4_4_4_5_g4_Exit leaving = voxc_d4_4_4_5_g4_Exit(0.0f, bvec3(false), true);
  // The condition stands at the head: Mesa 22.3's llvmpipe lets lanes that leave a loop further down run on.
  while (leaving.sure && left > 0) {
    face += side * mix(ivec3(0), ray.heading, leaving.passed);
    leaving = voxc_d4_4_4_5_g4_leave(ray, vec3(face));
    ivec3 step = mix(ivec3(0), ray.heading, leaving.passed);
    corner = face + side * (step - (ray.ahead & 1));
    left = voxc_d4_4_4_5_g4_within_level_1(corner) ? left - (abs(step.x) + abs(step.y) + abs(step.z)) : 0;
  }
  if (side > 1)
    corner = voxc_d4_4_4_5_g4_cell_beyond(ray, vec3(face), leaving);
  voxc_d4_4_4_5_g4_end_step(traversal, leaving, corner, voxc_d4_4_4_5_g4_EmptySpan(voxc_d4_4_4_5_g4_LEVEL_1_LOG2_CELL,
      1));
}

bool voxc_d4_4_4_5_g4_intersect_level_1(VOXC_VOLUME volume, const voxc_d4_4_4_5_g4_Ray ray,
    inout voxc_d4_4_4_5_g4_Traversal traversal, uint grid) {
  while (voxc_d4_4_4_5_g4_goes_on(traversal)) {
    voxc_d4_4_4_5_g4_EmptySpan span = voxc_d4_4_4_5_g4_EmptySpan(voxc_d4_4_4_5_g4_LEVEL_1_LOG2_CELL, 1);
    uint value = voxc_d4_4_4_5_g4_look_up_level_1(volume, grid, traversal.cell >> voxc_d4_4_4_5_g4_LEVEL_1_LOG2_CELL,
        span);
    if (value == 0u) {
      voxc_d4_4_4_5_g4_march_level_1(ray, traversal, span.count);
    } else if (voxc_d4_4_4_5_g4_intersect_level_2(volume, ray, traversal, value)) {
      return true;
    }
  }
  return false;
}

// What a voxel is: here its value is its colour.
uint voxc_d4_4_4_5_g4_colour_of(VOXC_VOLUME volume, const voxc_d4_4_4_5_g4_Traversal traversal) {
  return voxc_d4_4_4_5_g4_load_word(volume, traversal.voxel);
}

