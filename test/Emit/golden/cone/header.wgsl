// ---- The format: R(3, 3, 3) M(2, 2, 2) ----

// Level 2: masked, 4 x 4 x 4 cells of 1 voxel a side.
const voxc_r3_3_3_m2_2_2_LEVEL_2_LOG2_CELL: i32 = 0;
const voxc_r3_3_3_m2_2_2_LEVEL_2_LOG2_SIDE: i32 = 2;

// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty,
// unless all are alike.

// The value of the cell that is not empty after so many others.
fn voxc_r3_3_3_m2_2_2_value_of_slot_level_2(volume: u32, grid: u32, slot: u32) -> u32 {
  return voxc_r3_3_3_m2_2_2_load_word(volume, grid + 2u + slot);
}

// The number of a cell's bit, of which each word of the mask has 32.
fn voxc_r3_3_3_m2_2_2_number_level_2(cell: vec3<i32>) -> i32 {
  return (cell.x & 3) | ((cell.y & 3) << 2u) | ((cell.z & 3) << 4u);
}

// The value of a cell that is not empty.
fn voxc_r3_3_3_m2_2_2_value_level_2(volume: u32, grid: u32, cell: vec3<i32>) -> u32 {
  let number = voxc_r3_3_3_m2_2_2_number_level_2(cell);
  let low = voxc_r3_3_3_m2_2_2_load_word(volume, grid);
  var half_mask: u32;
  if (number < 32) {
    half_mask = low;
  } else {
    half_mask = voxc_r3_3_3_m2_2_2_load_word(volume, grid + 1u);
  }
  let rank = i32(countOneBits(half_mask & ((1u << u32(number & 31)) - 1u))) + select(i32(countOneBits(low)), 0,
      number < 32);
  return voxc_r3_3_3_m2_2_2_value_of_slot_level_2(volume, grid, u32(rank));
}

// True if a cell is full. Else the empty span is as wide as the aligned group of eight cells around it, if they are all
// empty, or as the grid, if no cell is full that the ray may still come to.
fn voxc_r3_3_3_m2_2_2_is_full_level_2(volume: u32, grid: u32, cell: vec3<i32>, span: ptr<function,
    voxc_r3_3_3_m2_2_2_EmptySpan>) -> bool {
  let number = voxc_r3_3_3_m2_2_2_number_level_2(cell);
  // Half of the mask tells of the group. To know more of four voxels a side takes longer than the steps that it would
  // save.
  let half_mask = voxc_r3_3_3_m2_2_2_load_word(volume, grid + u32(number >> 5u));
  (*span).log2_side += select(0, 1, ((half_mask >> u32(number & 10)) & 0x00330033u) == 0u);
  return ((half_mask >> u32(number & 31)) & 1u) != 0u;
}

// The same, and the value of a cell that is full; 0 of one that is not.
fn voxc_r3_3_3_m2_2_2_look_up_level_2(volume: u32, grid: u32, cell: vec3<i32>, span: ptr<function,
    voxc_r3_3_3_m2_2_2_EmptySpan>) -> u32 {
  // Its value is looked up once it is hit.
  return select(0u, grid, voxc_r3_3_3_m2_2_2_is_full_level_2(volume, grid, cell, span));
}

// Whether a traversal is still in the sub-volume in which it began.
fn voxc_r3_3_3_m2_2_2_within_level_2(begin: vec3<i32>, cell: vec3<i32>) -> bool {
  return voxc_r3_3_3_m2_2_2_is_same_cube(begin, cell, voxc_r3_3_3_m2_2_2_LEVEL_2_LOG2_SIDE);
}

fn voxc_r3_3_3_m2_2_2_intersect_level_2(volume: u32, ray: voxc_r3_3_3_m2_2_2_Ray, traversal: ptr<function,
    voxc_r3_3_3_m2_2_2_Traversal>, grid: u32) -> bool {
  let begin = (*traversal).cell;
  while (voxc_r3_3_3_m2_2_2_within_level_2(begin, (*traversal).cell)) {
    var span: voxc_r3_3_3_m2_2_2_EmptySpan = voxc_r3_3_3_m2_2_2_EmptySpan(voxc_r3_3_3_m2_2_2_LEVEL_2_LOG2_CELL, 1);
    let value = voxc_r3_3_3_m2_2_2_look_up_level_2(volume, grid,
        (*traversal).cell >> vec3<u32>(u32(voxc_r3_3_3_m2_2_2_LEVEL_2_LOG2_CELL)), &span);
    if (value == 0u) {
      voxc_r3_3_3_m2_2_2_step_over_emptyspan(ray, traversal, span);
    } else if (voxc_r3_3_3_m2_2_2_intersect_voxel(traversal, value)) {
      return true;
    }
  }
  return false;
}

// Level 1: raw, 8 x 8 x 8 cells of 4 voxels a side.
const voxc_r3_3_3_m2_2_2_LEVEL_1_LOG2_SIZE: vec3<i32> = vec3<i32>(3, 3, 3);
const voxc_r3_3_3_m2_2_2_LEVEL_1_LOG2_CELL: i32 = 2;

// A grid has a slot a cell, x fastest, then y, then z.
// The place of a cell's slot: in that granule, where references count granules.
fn voxc_r3_3_3_m2_2_2_slot_level_1(grid: u32, cell: vec3<i32>) -> u32 {
  let at = cell;
  return grid + u32(at.x + ((at.y
      + (at.z << u32(voxc_r3_3_3_m2_2_2_LEVEL_1_LOG2_SIZE.y))) << u32(voxc_r3_3_3_m2_2_2_LEVEL_1_LOG2_SIZE.x)));
}

// The value of a cell, or 0 if it is empty.
fn voxc_r3_3_3_m2_2_2_cell_level_1(volume: u32, grid: u32, cell: vec3<i32>) -> u32 {
  let slot = voxc_r3_3_3_m2_2_2_slot_level_1(grid, cell);
  return voxc_r3_3_3_m2_2_2_load_word(volume, slot);
}

fn voxc_r3_3_3_m2_2_2_intersect_level_1(volume: u32, ray: voxc_r3_3_3_m2_2_2_Ray, traversal: ptr<function,
    voxc_r3_3_3_m2_2_2_Traversal>, grid: u32) -> bool {
  while (voxc_r3_3_3_m2_2_2_goes_on(*traversal)) {
    let span = voxc_r3_3_3_m2_2_2_EmptySpan(voxc_r3_3_3_m2_2_2_LEVEL_1_LOG2_CELL, 1);
    let value = voxc_r3_3_3_m2_2_2_cell_level_1(volume, grid,
        (*traversal).cell >> vec3<u32>(u32(voxc_r3_3_3_m2_2_2_LEVEL_1_LOG2_CELL)));
    if (value == 0u) {
      voxc_r3_3_3_m2_2_2_step_over_emptyspan(ray, traversal, span);
    } else if (voxc_r3_3_3_m2_2_2_intersect_level_2(volume, ray, traversal, value)) {
      return true;
    }
  }
  return false;
}

// What a voxel is: here its value is its colour.
fn voxc_r3_3_3_m2_2_2_colour_of(volume: u32, traversal: voxc_r3_3_3_m2_2_2_Traversal) -> u32 {
  return voxc_r3_3_3_m2_2_2_value_level_2(volume, traversal.voxel, traversal.cell);
}

