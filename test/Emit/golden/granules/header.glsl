// ---- The format: R(3, 3, 3) R(3, 3, 3) ----

// Level 2: raw, 8 x 8 x 8 cells of 1 voxel a side.
const ivec3 voxc_r3_3_3_r3_3_3_LEVEL_2_LOG2_SIZE = ivec3(3, 3, 3);
const int voxc_r3_3_3_r3_3_3_LEVEL_2_LOG2_CELL = 0;
const int voxc_r3_3_3_r3_3_3_LEVEL_2_LOG2_SIDE = 3;

// The granule in which a cell's slot is.
uint voxc_r3_3_3_r3_3_3_granule_level_2(uint grid, ivec3 cell) {
  ivec3 at = cell & ((ivec3(1) << voxc_r3_3_3_r3_3_3_LEVEL_2_LOG2_SIZE) - 1);
  int granule = at.x >> 1 | at.y << 2 | at.z << 5;
  return grid + uint(granule);
}

// A grid has a slot a cell, x fastest, then y, then z.
// The place of a cell's slot: in that granule, where references count granules.
uint voxc_r3_3_3_r3_3_3_slot_level_2(ivec3 cell) {
  ivec3 at = cell & ((ivec3(1) << voxc_r3_3_3_r3_3_3_LEVEL_2_LOG2_SIZE) - 1);
  int slot = at.x & 1;
  return uint(slot);
}

// The value of a cell, or 0 if it is empty.
uint voxc_r3_3_3_r3_3_3_cell_level_2(VOXC_VOLUME volume, uint grid, ivec3 cell) {
  uint granule = voxc_r3_3_3_r3_3_3_granule_level_2(grid, cell);
  uint slot = voxc_r3_3_3_r3_3_3_slot_level_2(cell);
  return voxc_r3_3_3_r3_3_3_load_word(volume, granule, slot);
}

// Whether a traversal is still in the sub-volume in which it began.
bool voxc_r3_3_3_r3_3_3_within_level_2(ivec3 begin, ivec3 cell) {
  return voxc_r3_3_3_r3_3_3_is_same_cube(begin, cell, voxc_r3_3_3_r3_3_3_LEVEL_2_LOG2_SIDE);
}

bool voxc_r3_3_3_r3_3_3_intersect_level_2(VOXC_VOLUME volume, const voxc_r3_3_3_r3_3_3_Ray ray,
    inout voxc_r3_3_3_r3_3_3_Traversal traversal, uint grid) {
  ivec3 begin = traversal.cell;
  while (voxc_r3_3_3_r3_3_3_within_level_2(begin, traversal.cell)) {
    uint value = voxc_r3_3_3_r3_3_3_cell_level_2(volume, grid, traversal.cell >> voxc_r3_3_3_r3_3_3_LEVEL_2_LOG2_CELL);
    if (value == 0u) {
      voxc_r3_3_3_r3_3_3_step_over_voxel(ray, traversal);
    } else if (voxc_r3_3_3_r3_3_3_intersect_voxel(traversal, value)) {
      return true;
    }
  }
  return false;
}

// Level 1: raw, 8 x 8 x 8 cells of 8 voxels a side.
const int voxc_r3_3_3_r3_3_3_LEVEL_1_LOG2_CELL = 3;

// The granule in which a cell's slot is.
uint voxc_r3_3_3_r3_3_3_granule_level_1(uint grid, ivec3 cell) {
  ivec3 at = cell;
  int granule = at.x >> 1 | at.y << 2 | at.z << 5;
  return grid + uint(granule);
}

// A grid has a slot a cell, x fastest, then y, then z.
// The place of a cell's slot: in that granule, where references count granules.
uint voxc_r3_3_3_r3_3_3_slot_level_1(ivec3 cell) {
  ivec3 at = cell;
  int slot = at.x & 1;
  return uint(slot);
}

// The value of a cell, or 0 if it is empty.
uint voxc_r3_3_3_r3_3_3_cell_level_1(VOXC_VOLUME volume, uint grid, ivec3 cell) {
  uint granule = voxc_r3_3_3_r3_3_3_granule_level_1(grid, cell);
  uint slot = voxc_r3_3_3_r3_3_3_slot_level_1(cell);
  return voxc_r3_3_3_r3_3_3_load_word(volume, granule, slot);
}

bool voxc_r3_3_3_r3_3_3_intersect_level_1(VOXC_VOLUME volume, const voxc_r3_3_3_r3_3_3_Ray ray,
    inout voxc_r3_3_3_r3_3_3_Traversal traversal, uint grid) {
  while (voxc_r3_3_3_r3_3_3_goes_on(traversal)) {
    voxc_r3_3_3_r3_3_3_EmptySpan span = voxc_r3_3_3_r3_3_3_EmptySpan(voxc_r3_3_3_r3_3_3_LEVEL_1_LOG2_CELL, 1);
    uint value = voxc_r3_3_3_r3_3_3_cell_level_1(volume, grid, traversal.cell >> voxc_r3_3_3_r3_3_3_LEVEL_1_LOG2_CELL);
    if (value == 0u) {
      voxc_r3_3_3_r3_3_3_step_over(ray, traversal, span);
    } else if (voxc_r3_3_3_r3_3_3_intersect_level_2(volume, ray, traversal, value)) {
      return true;
    }
  }
  return false;
}

// What a voxel is: here its value is its colour.
uint voxc_r3_3_3_r3_3_3_colour_of(const voxc_r3_3_3_r3_3_3_Traversal traversal) { return traversal.voxel; }

