// ---- The format: D(7, 7, 7, 15) M(2, 2, 2) ----

// Level 2: masked, 4 x 4 x 4 cells of 1 voxel a side.
const int LEVEL_2_LOG2_CELL = 0;

// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty,
// unless all are alike.

// The value of the cell that is not empty after so many others.
uint value_of_slot_level_2(uint grid, uint slot) { return load_word(grid + 2u + slot); }

// The number of a cell's bit, of which each word of the mask has 32.
int number_level_2(ivec3 cell) { return (cell.x & 3) | (cell.y & 3) << 2 | (cell.z & 3) << 4; }

// The value of a cell that is not empty.
uint value_level_2(uint grid, ivec3 cell) {
  int number = number_level_2(cell);
  uint low = load_word(grid);
  uint half_mask = number < 32 ? low : load_word(grid + 1u);
  int rank = bitCount(half_mask & ((1u << (number & 31)) - 1u)) + (number < 32 ? 0 : bitCount(low));
  return value_of_slot_level_2(grid, uint(rank));
}

// True if a cell is full. Else the empty span is as wide as the aligned group of eight cells around it, if they are all
// empty, or as the grid, if no cell is full that the ray may still come to.
bool is_full_level_2(uint grid, ivec3 cell, inout EmptySpan span) {
  int number = number_level_2(cell);
  // Half of the mask tells of the group. To know more of four voxels a side takes longer than the steps that it would
  // save.
  uint half_mask = load_word(grid + uint(number >> 5));
  span.log2_side += (half_mask >> (number & 10) & 0x00330033u) == 0u ? 1 : 0;
  return (half_mask >> (number & 31) & 1u) != 0u;
}

// The same, and the value of a cell that is full; 0 of one that is not.
uint look_up_level_2(uint grid, ivec3 cell, inout EmptySpan span) {
  return is_full_level_2(grid, cell, span) ? grid : 0u; // Its value is looked up once it is hit.
}

// The faces ahead of what a mask may tell to be empty. They are made before it is known which of these it is, since the
// mask comes late: to choose is then all that is left to do.
vec3 faces_level_2(const Ray ray, ivec3 cell, const EmptySpan span) {
  vec3 of_cell = vec3(faces_ahead(ray, cell, EmptySpan(LEVEL_2_LOG2_CELL, 1)));
  vec3 of_group = vec3(faces_ahead(ray, cell, EmptySpan(LEVEL_2_LOG2_CELL + 1, 1)));
  return span.log2_side == LEVEL_2_LOG2_CELL ? of_cell : of_group;
}

// The voxel around a cell, from this grid down; 0, and what is empty there with its faces ahead, if there is none.
uint locate_level_2(const Ray ray, uint grid, ivec3 cell, inout EmptySpan span, inout vec3 face) {
  span = EmptySpan(LEVEL_2_LOG2_CELL, 1);
  uint value = look_up_level_2(grid, cell >> LEVEL_2_LOG2_CELL, span);
  if (value == 0u)
    face = faces_level_2(ray, cell, span);
  return value;
}

// Level 1: distance, 128 x 128 x 128 cells of 4 voxels a side.
const ivec3 LEVEL_1_LOG2_SIZE = ivec3(7, 7, 7);
const int LEVEL_1_LOG2_CELL = 2;

// A grid has a slot a cell, x fastest, then y, then z.
// The place of a cell's slot: in that granule, where references count granules.
uint slot_level_1(uint grid, ivec3 cell) {
  ivec3 at = cell;
  return grid + 2u * uint(at.x + ((at.y + (at.z << LEVEL_1_LOG2_SIZE.y)) << LEVEL_1_LOG2_SIZE.x));
}

// The value of a cell, or 0 if it is empty; `span` then counts the cells of its distance.
uint look_up_level_1(const Ray ray, uint grid, ivec3 cell, inout EmptySpan span) {
  uint slot = slot_level_1(grid, cell);
  uint word = load_word(slot);
  // The distance stands behind the value.
  uint skip = word == 0u ? load_word(slot + 1u) : 0u;
  span.count = int(skip >> (ray.octant * 4) & 15u);
  return word;
}

// The voxel around a cell, from this grid down; 0, and what is empty there with its faces ahead, if there is none.
uint locate_level_1(const Ray ray, uint grid, ivec3 cell, inout EmptySpan span, inout vec3 face) {
  span = EmptySpan(LEVEL_1_LOG2_CELL, 1);
  uint value = look_up_level_1(ray, grid, cell >> LEVEL_1_LOG2_CELL, span);
  if (value == 0u)
    face = vec3(faces_ahead(ray, cell, span));
  return value == 0u ? 0u : locate_level_2(ray, value, cell, span, face);
}

// One loop. Each turn looks at the traversal's cell from the root on, through all levels.
bool intersect_level_1(const Ray ray, inout Traversal traversal, uint root) {
  ivec3 before = traversal.cell;
  while (goes_on(traversal)) {
    count_lookup(traversal);
    EmptySpan span = EmptySpan(0, 1);
    vec3 face = vec3(0);
    uint value = locate_level_1(ray, root, traversal.cell, span, face);
    if (value != 0u) {
      traversal.voxel = value;
      return true;
    }
    before = traversal.cell;
    step_over(ray, traversal, span, face);
  }
  put_outside(traversal, before);
  return false;
}

// What a voxel is: here its value is its colour.
uint colour_of(const Traversal traversal) { return value_level_2(traversal.voxel, traversal.cell); }

