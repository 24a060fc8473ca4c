// ---- The format: M(4, 4, 4) M(3, 3, 3) ----

// Level 2: masked, 8 x 8 x 8 cells of 1 voxel a side.
const ivec3 voxc_m4_4_4_m3_3_3_LEVEL_2_LOG2_SIZE = ivec3(3, 3, 3);
const int voxc_m4_4_4_m3_3_3_LEVEL_2_LOG2_CELL = 0;
const int voxc_m4_4_4_m3_3_3_LEVEL_2_LOG2_SIDE = 3;

// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty,
// unless all are alike.

// The value of the cell that is not empty after so many others.
uint voxc_m4_4_4_m3_3_3_value_of_slot_level_2(VOXC_VOLUME volume, uint grid, uint slot) {
  return voxc_m4_4_4_m3_3_3_load_word(volume, grid + 32u + slot);
}

// The value of a cell, or 0 if it is empty.
uint voxc_m4_4_4_m3_3_3_cell_level_2(VOXC_VOLUME volume, uint grid, ivec3 cell) {
  ivec3 at = cell & ((ivec3(1) << voxc_m4_4_4_m3_3_3_LEVEL_2_LOG2_SIZE) - 1);
  uint number = uint(at.x + ((at.y
      + (at.z << voxc_m4_4_4_m3_3_3_LEVEL_2_LOG2_SIZE.y)) << voxc_m4_4_4_m3_3_3_LEVEL_2_LOG2_SIZE.x));
  uint bit = 1u << (number & 31u);
  uint mask = voxc_m4_4_4_m3_3_3_load_word(volume, grid + 2u * (number >> 5));
  if ((mask & bit) == 0u)
    return 0u;
  uint rank = uint(bitCount(mask & (bit - 1u)));
  // Each word of the mask is followed by how many bits the words before it have.
  rank += voxc_m4_4_4_m3_3_3_load_word(volume, grid + 2u * (number >> 5) + 1u);
  return voxc_m4_4_4_m3_3_3_value_of_slot_level_2(volume, grid, rank);
}

// Whether a traversal is still in the sub-volume in which it began.
bool voxc_m4_4_4_m3_3_3_within_level_2(ivec3 begin, ivec3 cell) {
  return voxc_m4_4_4_m3_3_3_is_same_cube(begin, cell, voxc_m4_4_4_m3_3_3_LEVEL_2_LOG2_SIDE);
}

bool voxc_m4_4_4_m3_3_3_intersect_level_2(VOXC_VOLUME volume, const voxc_m4_4_4_m3_3_3_Ray ray,
    inout voxc_m4_4_4_m3_3_3_Traversal traversal, uint grid) {
  ivec3 begin = traversal.cell;
  while (voxc_m4_4_4_m3_3_3_within_level_2(begin, traversal.cell)) {
    uint value = voxc_m4_4_4_m3_3_3_cell_level_2(volume, grid, traversal.cell >> voxc_m4_4_4_m3_3_3_LEVEL_2_LOG2_CELL);
    if (value == 0u) {
      voxc_m4_4_4_m3_3_3_step_over_voxel(ray, traversal);
    } else if (voxc_m4_4_4_m3_3_3_intersect_voxel(traversal, value)) {
      return true;
    }
  }
  return false;
}

// Level 1: masked, 16 x 16 x 16 cells of 8 voxels a side.
const ivec3 voxc_m4_4_4_m3_3_3_LEVEL_1_LOG2_SIZE = ivec3(4, 4, 4);
const int voxc_m4_4_4_m3_3_3_LEVEL_1_LOG2_CELL = 3;

// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty,
// unless all are alike.

// The value of the cell that is not empty after so many others.
uint voxc_m4_4_4_m3_3_3_value_of_slot_level_1(VOXC_VOLUME volume, uint grid, uint slot) {
  return voxc_m4_4_4_m3_3_3_load_word(volume, grid + 256u + slot);
}

// The value of a cell, or 0 if it is empty.
uint voxc_m4_4_4_m3_3_3_cell_level_1(VOXC_VOLUME volume, uint grid, ivec3 cell) {
  ivec3 at = cell;
  uint number = uint(at.x + ((at.y
      + (at.z << voxc_m4_4_4_m3_3_3_LEVEL_1_LOG2_SIZE.y)) << voxc_m4_4_4_m3_3_3_LEVEL_1_LOG2_SIZE.x));
  uint bit = 1u << (number & 31u);
  uint mask = voxc_m4_4_4_m3_3_3_load_word(volume, grid + 2u * (number >> 5));
  if ((mask & bit) == 0u)
    return 0u;
  uint rank = uint(bitCount(mask & (bit - 1u)));
  // Each word of the mask is followed by how many bits the words before it have.
  rank += voxc_m4_4_4_m3_3_3_load_word(volume, grid + 2u * (number >> 5) + 1u);
  return voxc_m4_4_4_m3_3_3_value_of_slot_level_1(volume, grid, rank);
}

bool voxc_m4_4_4_m3_3_3_intersect_level_1(VOXC_VOLUME volume, const voxc_m4_4_4_m3_3_3_Ray ray,
    inout voxc_m4_4_4_m3_3_3_Traversal traversal, uint grid) {
  while (voxc_m4_4_4_m3_3_3_goes_on(traversal)) {
    voxc_m4_4_4_m3_3_3_EmptySpan span = voxc_m4_4_4_m3_3_3_EmptySpan(voxc_m4_4_4_m3_3_3_LEVEL_1_LOG2_CELL, 1);
    uint value = voxc_m4_4_4_m3_3_3_cell_level_1(volume, grid, traversal.cell >> voxc_m4_4_4_m3_3_3_LEVEL_1_LOG2_CELL);
    if (value == 0u) {
      voxc_m4_4_4_m3_3_3_step_over(ray, traversal, span);
    } else if (voxc_m4_4_4_m3_3_3_intersect_level_2(volume, ray, traversal, value)) {
      return true;
    }
  }
  return false;
}

// What a voxel is: here its value is its colour.
uint voxc_m4_4_4_m3_3_3_colour_of(const voxc_m4_4_4_m3_3_3_Traversal traversal) { return traversal.voxel; }

