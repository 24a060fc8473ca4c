// ---- The format: R(3, 3, 3) R(3, 3, 3) ----

// Level 2: raw, 8 x 8 x 8 cells of 1 voxel a side.
const voxc_r3_3_3_r3_3_3_LEVEL_2_LOG2_SIZE: vec3<i32> = vec3<i32>(3, 3, 3);
const voxc_r3_3_3_r3_3_3_LEVEL_2_LOG2_CELL: i32 = 0;
const voxc_r3_3_3_r3_3_3_LEVEL_2_LOG2_SIDE: i32 = 3;

// The granule in which a cell's slot is.
fn voxc_r3_3_3_r3_3_3_granule_level_2(grid: u32, cell: vec3<i32>) -> u32 {
  let at = cell & ((vec3<i32>(1) << vec3<u32>(voxc_r3_3_3_r3_3_3_LEVEL_2_LOG2_SIZE)) - 1);
  let granule = (at.x >> 1u) | (at.y << 2u) | (at.z << 5u);
  return grid + u32(granule);
}

// A grid has a slot a cell, x fastest, then y, then z.
// The place of a cell's slot: in that granule, where references count granules.
fn voxc_r3_3_3_r3_3_3_slot_level_2(cell: vec3<i32>) -> u32 {
  let at = cell & ((vec3<i32>(1) << vec3<u32>(voxc_r3_3_3_r3_3_3_LEVEL_2_LOG2_SIZE)) - 1);
  let slot = at.x & 1;
  return u32(slot);
}

// The value of a cell, or 0 if it is empty.
fn voxc_r3_3_3_r3_3_3_cell_level_2(volume: u32, grid: u32, cell: vec3<i32>) -> u32 {
  let granule = voxc_r3_3_3_r3_3_3_granule_level_2(grid, cell);
  let slot = voxc_r3_3_3_r3_3_3_slot_level_2(cell);
  return voxc_r3_3_3_r3_3_3_load_word(volume, granule, slot);
}

// Whether a traversal is still in the sub-volume in which it began.
fn voxc_r3_3_3_r3_3_3_within_level_2(begin: vec3<i32>, cell: vec3<i32>) -> bool {
  return voxc_r3_3_3_r3_3_3_is_same_cube(begin, cell, voxc_r3_3_3_r3_3_3_LEVEL_2_LOG2_SIDE);
}

fn voxc_r3_3_3_r3_3_3_intersect_level_2(volume: u32, ray: voxc_r3_3_3_r3_3_3_Ray, traversal: ptr<function,
    voxc_r3_3_3_r3_3_3_Traversal>, grid: u32) -> bool {
  let begin = (*traversal).cell;
  while (voxc_r3_3_3_r3_3_3_within_level_2(begin, (*traversal).cell)) {
    let value = voxc_r3_3_3_r3_3_3_cell_level_2(volume, grid,
        (*traversal).cell >> vec3<u32>(u32(voxc_r3_3_3_r3_3_3_LEVEL_2_LOG2_CELL)));
    if (value == 0u) {
      voxc_r3_3_3_r3_3_3_step_over_voxel(ray, traversal);
    } else if (voxc_r3_3_3_r3_3_3_intersect_voxel(traversal, value)) {
      return true;
    }
  }
  return false;
}

// Level 1: raw, 8 x 8 x 8 cells of 8 voxels a side.
const voxc_r3_3_3_r3_3_3_LEVEL_1_LOG2_CELL: i32 = 3;

// The granule in which a cell's slot is.
fn voxc_r3_3_3_r3_3_3_granule_level_1(grid: u32, cell: vec3<i32>) -> u32 {
  let at = cell;
  let granule = (at.x >> 1u) | (at.y << 2u) | (at.z << 5u);
  return grid + u32(granule);
}

// A grid has a slot a cell, x fastest, then y, then z.
// The place of a cell's slot: in that granule, where references count granules.
fn voxc_r3_3_3_r3_3_3_slot_level_1(cell: vec3<i32>) -> u32 {
  let at = cell;
  let slot = at.x & 1;
  return u32(slot);
}

// The value of a cell, or 0 if it is empty.
fn voxc_r3_3_3_r3_3_3_cell_level_1(volume: u32, grid: u32, cell: vec3<i32>) -> u32 {
  let granule = voxc_r3_3_3_r3_3_3_granule_level_1(grid, cell);
  let slot = voxc_r3_3_3_r3_3_3_slot_level_1(cell);
  return voxc_r3_3_3_r3_3_3_load_word(volume, granule, slot);
}

fn voxc_r3_3_3_r3_3_3_intersect_level_1(volume: u32, ray: voxc_r3_3_3_r3_3_3_Ray, traversal: ptr<function,
    voxc_r3_3_3_r3_3_3_Traversal>, grid: u32) -> bool {
  while (voxc_r3_3_3_r3_3_3_goes_on(*traversal)) {
    let span = voxc_r3_3_3_r3_3_3_EmptySpan(voxc_r3_3_3_r3_3_3_LEVEL_1_LOG2_CELL, 1);
    let value = voxc_r3_3_3_r3_3_3_cell_level_1(volume, grid,
        (*traversal).cell >> vec3<u32>(u32(voxc_r3_3_3_r3_3_3_LEVEL_1_LOG2_CELL)));
    if (value == 0u) {
      voxc_r3_3_3_r3_3_3_step_over_emptyspan(ray, traversal, span);
    } else if (voxc_r3_3_3_r3_3_3_intersect_level_2(volume, ray, traversal, value)) {
      return true;
    }
  }
  return false;
}

// What a voxel is: here its value is its colour.
fn voxc_r3_3_3_r3_3_3_colour_of(traversal: voxc_r3_3_3_r3_3_3_Traversal) -> u32 { return traversal.voxel; }

