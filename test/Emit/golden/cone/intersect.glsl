// ---- The format: R(3, 3, 3) M(2, 2, 2) ----

// Level 2: masked, 4 x 4 x 4 cells of 1 voxel a side.
const int LEVEL_2_LOG2_CELL = 0;
const int LEVEL_2_LOG2_SIDE = 2;

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
  return is_full_level_2(grid, cell, span) ? value_level_2(grid, cell) : 0u;
}

// The first value of the grid.
uint any_value_level_2(uint grid) { return value_of_slot_level_2(grid, 0u); }

// The colour of a voxel of the grid. 0 if the device cut the search short.
uint sample_level_2(uint grid) {
  uint value = any_value_level_2(grid);
  return value == 0u ? 0u : sample_voxel(value);
}

// Whether a traversal is still in the sub-volume in which it began.
bool within_level_2(ivec3 begin, ivec3 cell) { return is_same_cube(begin, cell, LEVEL_2_LOG2_SIDE); }

bool intersect_level_2(const Ray ray, inout Traversal traversal, uint grid) {
  ivec3 begin = traversal.cell;
  while (within_level_2(begin, traversal.cell)) {
    count_lookup(traversal);
    EmptySpan span = EmptySpan(LEVEL_2_LOG2_CELL, 1);
    uint value = look_up_level_2(grid, traversal.cell >> LEVEL_2_LOG2_CELL, span);
    if (value == 0u) {
      step_over(ray, traversal, span);
    } else if (intersect_voxel(traversal, value)) {
      return true;
    }
  }
  return false;
}

// Level 1: raw, 8 x 8 x 8 cells of 4 voxels a side.
const ivec3 LEVEL_1_LOG2_SIZE = ivec3(3, 3, 3);
const int LEVEL_1_LOG2_CELL = 2;

// A grid has a slot a cell, x fastest, then y, then z.
// The place of a cell's slot: in that granule, where references count granules.
uint slot_level_1(uint grid, ivec3 cell) {
  ivec3 at = cell;
  return grid + uint(at.x + ((at.y + (at.z << LEVEL_1_LOG2_SIZE.y)) << LEVEL_1_LOG2_SIZE.x));
}

// The value of a cell, or 0 if it is empty.
uint cell_level_1(uint grid, ivec3 cell) {
  uint slot = slot_level_1(grid, cell);
  return load_word(slot);
}

bool intersect_level_1(const Ray ray, inout Traversal traversal, uint grid) {
  while (goes_on(traversal)) {
    count_lookup(traversal);
    EmptySpan span = EmptySpan(LEVEL_1_LOG2_CELL, 1);
    uint value = cell_level_1(grid, traversal.cell >> LEVEL_1_LOG2_CELL);
    if (value == 0u) {
      step_over(ray, traversal, span);
    } else if (small_height(ray, traversal) >= LEVEL_1_LOG2_CELL) {
      return stop_with(traversal, sample_level_2(value));
    } else if (intersect_level_2(ray, traversal, value)) {
      return true;
    }
  }
  return false;
}

// What a voxel is: here its value is its colour.
uint colour_of(const Traversal traversal) { return traversal.voxel; }

