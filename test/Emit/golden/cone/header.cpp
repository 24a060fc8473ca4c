// ---- The format: R(3, 3, 3) M(2, 2, 2) ----

// Level 2: masked, 4 x 4 x 4 cells of 1 voxel a side.
const int voxc_r3_3_3_m2_2_2_LEVEL_2_LOG2_CELL = 0;
const int voxc_r3_3_3_m2_2_2_LEVEL_2_LOG2_SIDE = 2;

// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty,
// unless all are alike.

// The value of the cell that is not empty after so many others.
static inline uint voxc_r3_3_3_m2_2_2_value_of_slot_level_2(const unsigned int *volume, uint grid, uint slot) {
  return voxc_r3_3_3_m2_2_2_load_word(volume, grid + 2u + slot);
}

// The number of a cell's bit, of which each word of the mask has 32.
static inline int voxc_r3_3_3_m2_2_2_number_level_2(ivec3 cell) {
  return (cell.x & 3) | (cell.y & 3) << 2 | (cell.z & 3) << 4;
}

// The value of a cell that is not empty.
static inline uint voxc_r3_3_3_m2_2_2_value_level_2(const unsigned int *volume, uint grid, ivec3 cell) {
  int number = voxc_r3_3_3_m2_2_2_number_level_2(cell);
  uint low = voxc_r3_3_3_m2_2_2_load_word(volume, grid);
  uint half_mask = number < 32 ? low : voxc_r3_3_3_m2_2_2_load_word(volume, grid + 1u);
  int rank = bitCount(half_mask & ((1u << (number & 31)) - 1u)) + (number < 32 ? 0 : bitCount(low));
  return voxc_r3_3_3_m2_2_2_value_of_slot_level_2(volume, grid, uint(rank));
}

// True if a cell is full. Else the empty span is as wide as the aligned group of eight cells around it, if they are all
// empty, or as the grid, if no cell is full that the ray may still come to.
static inline bool voxc_r3_3_3_m2_2_2_is_full_level_2(const unsigned int *volume, uint grid, ivec3 cell,
    voxc_r3_3_3_m2_2_2_EmptySpan &span) {
  int number = voxc_r3_3_3_m2_2_2_number_level_2(cell);
  // Half of the mask tells of the group. To know more of four voxels a side takes longer than the steps that it would
  // save.
  uint half_mask = voxc_r3_3_3_m2_2_2_load_word(volume, grid + uint(number >> 5));
  span.log2_side += (half_mask >> (number & 10) & 0x00330033u) == 0u ? 1 : 0;
  return (half_mask >> (number & 31) & 1u) != 0u;
}

// The same, and the value of a cell that is full; 0 of one that is not.
static inline uint voxc_r3_3_3_m2_2_2_look_up_level_2(const unsigned int *volume, uint grid, ivec3 cell,
    voxc_r3_3_3_m2_2_2_EmptySpan &span) {
  // Its value is looked up once it is hit.
  return voxc_r3_3_3_m2_2_2_is_full_level_2(volume, grid, cell, span) ? grid : 0u;
}

// Whether a traversal is still in the sub-volume in which it began.
static inline bool voxc_r3_3_3_m2_2_2_within_level_2(ivec3 begin, ivec3 cell) {
  return voxc_r3_3_3_m2_2_2_is_same_cube(begin, cell, voxc_r3_3_3_m2_2_2_LEVEL_2_LOG2_SIDE);
}

static inline bool voxc_r3_3_3_m2_2_2_intersect_level_2(const unsigned int *volume, const voxc_r3_3_3_m2_2_2_Ray &ray,
    voxc_r3_3_3_m2_2_2_Traversal &traversal, uint grid) {
  ivec3 begin = traversal.cell;
  while (voxc_r3_3_3_m2_2_2_within_level_2(begin, traversal.cell)) {
    voxc_r3_3_3_m2_2_2_EmptySpan span = voxc_r3_3_3_m2_2_2_EmptySpan(voxc_r3_3_3_m2_2_2_LEVEL_2_LOG2_CELL, 1);
    uint value = voxc_r3_3_3_m2_2_2_look_up_level_2(volume, grid,
        traversal.cell >> voxc_r3_3_3_m2_2_2_LEVEL_2_LOG2_CELL, span);
    if (value == 0u) {
      voxc_r3_3_3_m2_2_2_step_over(ray, traversal, span);
    } else if (voxc_r3_3_3_m2_2_2_intersect_voxel(traversal, value)) {
      return true;
    }
  }
  return false;
}

// Level 1: raw, 8 x 8 x 8 cells of 4 voxels a side.
const ivec3 voxc_r3_3_3_m2_2_2_LEVEL_1_LOG2_SIZE = ivec3(3, 3, 3);
const int voxc_r3_3_3_m2_2_2_LEVEL_1_LOG2_CELL = 2;

// A grid has a slot a cell, x fastest, then y, then z.
// The place of a cell's slot: in that granule, where references count granules.
static inline uint voxc_r3_3_3_m2_2_2_slot_level_1(uint grid, ivec3 cell) {
  ivec3 at = cell;
  return grid + uint(at.x + ((at.y
      + (at.z << voxc_r3_3_3_m2_2_2_LEVEL_1_LOG2_SIZE.y)) << voxc_r3_3_3_m2_2_2_LEVEL_1_LOG2_SIZE.x));
}

// The value of a cell, or 0 if it is empty.
static inline uint voxc_r3_3_3_m2_2_2_cell_level_1(const unsigned int *volume, uint grid, ivec3 cell) {
  uint slot = voxc_r3_3_3_m2_2_2_slot_level_1(grid, cell);
  return voxc_r3_3_3_m2_2_2_load_word(volume, slot);
}

static inline bool voxc_r3_3_3_m2_2_2_intersect_level_1(const unsigned int *volume, const voxc_r3_3_3_m2_2_2_Ray &ray,
    voxc_r3_3_3_m2_2_2_Traversal &traversal, uint grid) {
  while (voxc_r3_3_3_m2_2_2_goes_on(traversal)) {
    voxc_r3_3_3_m2_2_2_EmptySpan span = voxc_r3_3_3_m2_2_2_EmptySpan(voxc_r3_3_3_m2_2_2_LEVEL_1_LOG2_CELL, 1);
    uint value = voxc_r3_3_3_m2_2_2_cell_level_1(volume, grid, traversal.cell >> voxc_r3_3_3_m2_2_2_LEVEL_1_LOG2_CELL);
    if (value == 0u) {
      voxc_r3_3_3_m2_2_2_step_over(ray, traversal, span);
    } else if (voxc_r3_3_3_m2_2_2_intersect_level_2(volume, ray, traversal, value)) {
      return true;
    }
  }
  return false;
}

// What a voxel is: here its value is its colour.
static inline uint voxc_r3_3_3_m2_2_2_colour_of(const unsigned int *volume,
    const voxc_r3_3_3_m2_2_2_Traversal &traversal) {
  return voxc_r3_3_3_m2_2_2_value_level_2(volume, traversal.voxel, traversal.cell);
}

