// ---- The format: D(7, 7, 7, 15) M(2, 2, 2) ----

// Level 2: masked, 4 x 4 x 4 cells of 1 voxel a side.
static const int voxc_d7_7_7_15_m2_2_2_LEVEL_2_LOG2_CELL = 0;

// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty,
// unless all are alike.

// The value of the cell that is not empty after so many others.
uint voxc_d7_7_7_15_m2_2_2_value_of_slot_level_2(VOXC_VOLUME volume, uint grid, uint slot) {
  return voxc_d7_7_7_15_m2_2_2_load_word(volume, grid + 2u + slot);
}

// The number of a cell's bit, of which each word of the mask has 32.
int voxc_d7_7_7_15_m2_2_2_number_level_2(int3 cell) { return (cell.x & 3) | (cell.y & 3) << 2 | (cell.z & 3) << 4; }

// The value of a cell that is not empty.
uint voxc_d7_7_7_15_m2_2_2_value_level_2(VOXC_VOLUME volume, uint grid, int3 cell) {
  int number = voxc_d7_7_7_15_m2_2_2_number_level_2(cell);
  uint low = voxc_d7_7_7_15_m2_2_2_load_word(volume, grid);
  uint half_mask = number < 32 ? low : voxc_d7_7_7_15_m2_2_2_load_word(volume, grid + 1u);
  int rank = int(countbits(half_mask & ((1u << (number & 31)) - 1u))) + (number < 32 ? 0 : int(countbits(low)));
  return voxc_d7_7_7_15_m2_2_2_value_of_slot_level_2(volume, grid, uint(rank));
}

// True if a cell is full. Else the empty span is as wide as the aligned group of eight cells around it, if they are all
// empty, or as the grid, if no cell is full that the ray may still come to.
bool voxc_d7_7_7_15_m2_2_2_is_full_level_2(VOXC_VOLUME volume, uint grid, int3 cell,
    inout voxc_d7_7_7_15_m2_2_2_EmptySpan span) {
  int number = voxc_d7_7_7_15_m2_2_2_number_level_2(cell);
  // Half of the mask tells of the group. To know more of four voxels a side takes longer than the steps that it would
  // save.
  uint half_mask = voxc_d7_7_7_15_m2_2_2_load_word(volume, grid + uint(number >> 5));
  span.log2_side += (half_mask >> (number & 10) & 0x00330033u) == 0u ? 1 : 0;
  return (half_mask >> (number & 31) & 1u) != 0u;
}

// The same, and the value of a cell that is full; 0 of one that is not.
uint voxc_d7_7_7_15_m2_2_2_look_up_level_2(VOXC_VOLUME volume, uint grid, int3 cell,
    inout voxc_d7_7_7_15_m2_2_2_EmptySpan span) {
  // Its value is looked up once it is hit.
  return voxc_d7_7_7_15_m2_2_2_is_full_level_2(volume, grid, cell, span) ? grid : 0u;
}

// The faces ahead of what a mask may tell to be empty. They are made before it is known which of these it is, since the
// mask comes late: to choose is then all that is left to do.
float3 voxc_d7_7_7_15_m2_2_2_faces_level_2(const voxc_d7_7_7_15_m2_2_2_Ray ray, int3 cell,
    const voxc_d7_7_7_15_m2_2_2_EmptySpan span) {
  float3 of_cell = float3(voxc_d7_7_7_15_m2_2_2_faces_ahead(ray, cell,
      make_voxc_d7_7_7_15_m2_2_2_EmptySpan(voxc_d7_7_7_15_m2_2_2_LEVEL_2_LOG2_CELL, 1)));
  float3 of_group = float3(voxc_d7_7_7_15_m2_2_2_faces_ahead(ray, cell,
      make_voxc_d7_7_7_15_m2_2_2_EmptySpan(voxc_d7_7_7_15_m2_2_2_LEVEL_2_LOG2_CELL + 1, 1)));
  return span.log2_side == voxc_d7_7_7_15_m2_2_2_LEVEL_2_LOG2_CELL ? of_cell : of_group;
}

// The voxel around a cell, from this grid down; 0, and what is empty there with its faces ahead, if there is none.
uint voxc_d7_7_7_15_m2_2_2_locate_level_2(VOXC_VOLUME volume, const voxc_d7_7_7_15_m2_2_2_Ray ray, uint grid, int3 cell,
    inout voxc_d7_7_7_15_m2_2_2_EmptySpan span, inout float3 face) {
  span = make_voxc_d7_7_7_15_m2_2_2_EmptySpan(voxc_d7_7_7_15_m2_2_2_LEVEL_2_LOG2_CELL, 1);
  uint value = voxc_d7_7_7_15_m2_2_2_look_up_level_2(volume, grid, cell >> voxc_d7_7_7_15_m2_2_2_LEVEL_2_LOG2_CELL,
      span);
  if (value == 0u)
    face = voxc_d7_7_7_15_m2_2_2_faces_level_2(ray, cell, span);
  return value;
}

// Level 1: distance, 128 x 128 x 128 cells of 4 voxels a side.
static const int3 voxc_d7_7_7_15_m2_2_2_LEVEL_1_LOG2_SIZE = int3(7, 7, 7);
static const int voxc_d7_7_7_15_m2_2_2_LEVEL_1_LOG2_CELL = 2;

// A grid has a slot a cell, x fastest, then y, then z.
// The place of a cell's slot: in that granule, where references count granules.
uint voxc_d7_7_7_15_m2_2_2_slot_level_1(uint grid, int3 cell) {
  int3 at = cell;
  return grid + 2u * uint(at.x + ((at.y
      + (at.z << voxc_d7_7_7_15_m2_2_2_LEVEL_1_LOG2_SIZE.y)) << voxc_d7_7_7_15_m2_2_2_LEVEL_1_LOG2_SIZE.x));
}

// The value of a cell, or 0 if it is empty; `span` then counts the cells of its distance.
uint voxc_d7_7_7_15_m2_2_2_look_up_level_1(VOXC_VOLUME volume, const voxc_d7_7_7_15_m2_2_2_Ray ray, uint grid,
    int3 cell, inout voxc_d7_7_7_15_m2_2_2_EmptySpan span) {
  uint slot = voxc_d7_7_7_15_m2_2_2_slot_level_1(grid, cell);
  uint word = voxc_d7_7_7_15_m2_2_2_load_word(volume, slot);
  // The distance stands behind the value.
  uint skip = word == 0u ? voxc_d7_7_7_15_m2_2_2_load_word(volume, slot + 1u) : 0u;
  span.count = int(skip >> (ray.octant * 4) & 15u);
  return word;
}

// The voxel around a cell, from this grid down; 0, and what is empty there with its faces ahead, if there is none.
uint voxc_d7_7_7_15_m2_2_2_locate_level_1(VOXC_VOLUME volume, const voxc_d7_7_7_15_m2_2_2_Ray ray, uint grid, int3 cell,
    inout voxc_d7_7_7_15_m2_2_2_EmptySpan span, inout float3 face) {
  span = make_voxc_d7_7_7_15_m2_2_2_EmptySpan(voxc_d7_7_7_15_m2_2_2_LEVEL_1_LOG2_CELL, 1);
  uint value = voxc_d7_7_7_15_m2_2_2_look_up_level_1(volume, ray, grid, cell >> voxc_d7_7_7_15_m2_2_2_LEVEL_1_LOG2_CELL,
      span);
  if (value == 0u)
    face = float3(voxc_d7_7_7_15_m2_2_2_faces_ahead(ray, cell, span));
  if (value == 0u)
    return 0u;
  return voxc_d7_7_7_15_m2_2_2_locate_level_2(volume, ray, value, cell, span, face);
}

// One loop. Each turn looks at the traversal's cell from the root on, through all levels.
bool voxc_d7_7_7_15_m2_2_2_intersect_level_1(VOXC_VOLUME volume, const voxc_d7_7_7_15_m2_2_2_Ray ray,
    inout voxc_d7_7_7_15_m2_2_2_Traversal traversal, uint root) {
  int3 before = traversal.cell;
  while (voxc_d7_7_7_15_m2_2_2_goes_on(traversal)) {
    voxc_d7_7_7_15_m2_2_2_EmptySpan span = make_voxc_d7_7_7_15_m2_2_2_EmptySpan(0, 1);
    float3 face = (float3)0;
    uint value = voxc_d7_7_7_15_m2_2_2_locate_level_1(volume, ray, root, traversal.cell, span, face);
    if (value != 0u) {
      traversal.voxel = value;
      return true;
    }
    before = traversal.cell;
    voxc_d7_7_7_15_m2_2_2_step_over(ray, traversal, span, face);
  }
  voxc_d7_7_7_15_m2_2_2_put_outside(traversal, before);
  return false;
}

// What a voxel is: here its value is its colour.
uint voxc_d7_7_7_15_m2_2_2_colour_of(VOXC_VOLUME volume, const voxc_d7_7_7_15_m2_2_2_Traversal traversal) {
  return voxc_d7_7_7_15_m2_2_2_value_level_2(volume, traversal.voxel, traversal.cell);
}

