// ---- The format: M(4, 4, 4) M(3, 3, 3) ----

// Level 2: masked, 8 x 8 x 8 cells of 1 voxel a side.
const ivec3 LEVEL_2_LOG2_SIZE = ivec3(3, 3, 3);
const int LEVEL_2_LOG2_CELL = 0;
const int LEVEL_2_LOG2_SIDE = 3;

// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty,
// unless all are alike.

// The value of the cell that is not empty after so many others.
uint value_of_slot_level_2(uint grid, uint slot) { return load_word(grid + 32u + slot); }

// The value of a cell, or 0 if it is empty.
uint cell_level_2(uint grid, ivec3 cell) {
  ivec3 at = cell & ((ivec3(1) << LEVEL_2_LOG2_SIZE) - 1);
  uint number = uint(at.x + ((at.y + (at.z << LEVEL_2_LOG2_SIZE.y)) << LEVEL_2_LOG2_SIZE.x));
  uint bit = 1u << (number & 31u);
  uint mask = load_word(grid + 2u * (number >> 5));
  if ((mask & bit) == 0u)
    return 0u;
  uint rank = uint(bitCount(mask & (bit - 1u)));
  // Each word of the mask is followed by how many bits the words before it have.
  rank += load_word(grid + 2u * (number >> 5) + 1u);
  return value_of_slot_level_2(grid, rank);
}

// Whether a traversal is still in the sub-volume in which it began.
bool within_level_2(ivec3 begin, ivec3 cell) { return is_same_cube(begin, cell, LEVEL_2_LOG2_SIDE); }

bool intersect_level_2(const Ray ray, inout Traversal traversal, uint grid) {
  ivec3 begin = traversal.cell;
  while (within_level_2(begin, traversal.cell)) {
    count_lookup(traversal);
    uint value = cell_level_2(grid, traversal.cell >> LEVEL_2_LOG2_CELL);
    if (value == 0u) {
      step_over_voxel(ray, traversal);
    } else if (intersect_voxel(traversal, value)) {
      return true;
    }
  }
  return false;
}

// Level 1: masked, 16 x 16 x 16 cells of 8 voxels a side.
const ivec3 LEVEL_1_LOG2_SIZE = ivec3(4, 4, 4);
const int LEVEL_1_LOG2_CELL = 3;

// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty,
// unless all are alike.

// The value of the cell that is not empty after so many others.
uint value_of_slot_level_1(uint grid, uint slot) { return load_word(grid + 256u + slot); }

// The value of a cell, or 0 if it is empty.
uint cell_level_1(uint grid, ivec3 cell) {
  ivec3 at = cell;
  uint number = uint(at.x + ((at.y + (at.z << LEVEL_1_LOG2_SIZE.y)) << LEVEL_1_LOG2_SIZE.x));
  uint bit = 1u << (number & 31u);
  uint mask = load_word(grid + 2u * (number >> 5));
  if ((mask & bit) == 0u)
    return 0u;
  uint rank = uint(bitCount(mask & (bit - 1u)));
  // Each word of the mask is followed by how many bits the words before it have.
  rank += load_word(grid + 2u * (number >> 5) + 1u);
  return value_of_slot_level_1(grid, rank);
}

bool intersect_level_1(const Ray ray, inout Traversal traversal, uint grid) {
  while (goes_on(traversal)) {
    count_lookup(traversal);
    EmptySpan span = EmptySpan(LEVEL_1_LOG2_CELL, 1);
    uint value = cell_level_1(grid, traversal.cell >> LEVEL_1_LOG2_CELL);
    if (value == 0u) {
      step_over(ray, traversal, span);
    } else if (intersect_level_2(ray, traversal, value)) {
      return true;
    }
  }
  return false;
}

// What a voxel is: here its value is its colour.
uint colour_of(const Traversal traversal) { return traversal.voxel; }

