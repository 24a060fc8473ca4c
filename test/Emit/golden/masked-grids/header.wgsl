// ---- The format: M(4, 4, 4) M(3, 3, 3) ----

// Level 2: masked, 8 x 8 x 8 cells of 1 voxel a side.
const voxc_m4_4_4_m3_3_3_LEVEL_2_LOG2_SIZE: vec3<i32> = vec3<i32>(3, 3, 3);
const voxc_m4_4_4_m3_3_3_LEVEL_2_LOG2_CELL: i32 = 0;
const voxc_m4_4_4_m3_3_3_LEVEL_2_LOG2_SIDE: i32 = 3;

// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty,
// unless all are alike.

// The value of the cell that is not empty after so many others.
fn voxc_m4_4_4_m3_3_3_value_of_slot_level_2(volume: u32, grid: u32, slot: u32) -> u32 {
  return voxc_m4_4_4_m3_3_3_load_word(volume, grid + 32u + slot);
}

// The value of a cell, or 0 if it is empty.
fn voxc_m4_4_4_m3_3_3_cell_level_2(volume: u32, grid: u32, cell: vec3<i32>) -> u32 {
  let at = cell & ((vec3<i32>(1) << vec3<u32>(voxc_m4_4_4_m3_3_3_LEVEL_2_LOG2_SIZE)) - 1);
  let number = u32(at.x + ((at.y
      + (at.z << u32(voxc_m4_4_4_m3_3_3_LEVEL_2_LOG2_SIZE.y))) << u32(voxc_m4_4_4_m3_3_3_LEVEL_2_LOG2_SIZE.x)));
  let bit = 1u << (number & 31u);
  let mask = voxc_m4_4_4_m3_3_3_load_word(volume, grid + 2u * (number >> 5u));
  if ((mask & bit) == 0u) {
    return 0u;
  }
  var rank: u32 = countOneBits(mask & (bit - 1u));
  // Each word of the mask is followed by how many bits the words before it have.
  rank += voxc_m4_4_4_m3_3_3_load_word(volume, grid + 2u * (number >> 5u) + 1u);
  return voxc_m4_4_4_m3_3_3_value_of_slot_level_2(volume, grid, rank);
}

// Whether a traversal is still in the sub-volume in which it began.
fn voxc_m4_4_4_m3_3_3_within_level_2(begin: vec3<i32>, cell: vec3<i32>) -> bool {
  return voxc_m4_4_4_m3_3_3_is_same_cube(begin, cell, voxc_m4_4_4_m3_3_3_LEVEL_2_LOG2_SIDE);
}

fn voxc_m4_4_4_m3_3_3_intersect_level_2(volume: u32, ray: voxc_m4_4_4_m3_3_3_Ray, traversal: ptr<function,
    voxc_m4_4_4_m3_3_3_Traversal>, grid: u32) -> bool {
  let begin = (*traversal).cell;
  while (voxc_m4_4_4_m3_3_3_within_level_2(begin, (*traversal).cell)) {
    let value = voxc_m4_4_4_m3_3_3_cell_level_2(volume, grid,
        (*traversal).cell >> vec3<u32>(u32(voxc_m4_4_4_m3_3_3_LEVEL_2_LOG2_CELL)));
    if (value == 0u) {
      voxc_m4_4_4_m3_3_3_step_over_voxel(ray, traversal);
    } else if (voxc_m4_4_4_m3_3_3_intersect_voxel(traversal, value)) {
      return true;
    }
  }
  return false;
}

// Level 1: masked, 16 x 16 x 16 cells of 8 voxels a side.
const voxc_m4_4_4_m3_3_3_LEVEL_1_LOG2_SIZE: vec3<i32> = vec3<i32>(4, 4, 4);
const voxc_m4_4_4_m3_3_3_LEVEL_1_LOG2_CELL: i32 = 3;

// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty,
// unless all are alike.

// The value of the cell that is not empty after so many others.
fn voxc_m4_4_4_m3_3_3_value_of_slot_level_1(volume: u32, grid: u32, slot: u32) -> u32 {
  return voxc_m4_4_4_m3_3_3_load_word(volume, grid + 256u + slot);
}

// The value of a cell, or 0 if it is empty.
fn voxc_m4_4_4_m3_3_3_cell_level_1(volume: u32, grid: u32, cell: vec3<i32>) -> u32 {
  let at = cell;
  let number = u32(at.x + ((at.y
      + (at.z << u32(voxc_m4_4_4_m3_3_3_LEVEL_1_LOG2_SIZE.y))) << u32(voxc_m4_4_4_m3_3_3_LEVEL_1_LOG2_SIZE.x)));
  let bit = 1u << (number & 31u);
  let mask = voxc_m4_4_4_m3_3_3_load_word(volume, grid + 2u * (number >> 5u));
  if ((mask & bit) == 0u) {
    return 0u;
  }
  var rank: u32 = countOneBits(mask & (bit - 1u));
  // Each word of the mask is followed by how many bits the words before it have.
  rank += voxc_m4_4_4_m3_3_3_load_word(volume, grid + 2u * (number >> 5u) + 1u);
  return voxc_m4_4_4_m3_3_3_value_of_slot_level_1(volume, grid, rank);
}

fn voxc_m4_4_4_m3_3_3_intersect_level_1(volume: u32, ray: voxc_m4_4_4_m3_3_3_Ray, traversal: ptr<function,
    voxc_m4_4_4_m3_3_3_Traversal>, grid: u32) -> bool {
  while (voxc_m4_4_4_m3_3_3_goes_on(*traversal)) {
    let span = voxc_m4_4_4_m3_3_3_EmptySpan(voxc_m4_4_4_m3_3_3_LEVEL_1_LOG2_CELL, 1);
    let value = voxc_m4_4_4_m3_3_3_cell_level_1(volume, grid,
        (*traversal).cell >> vec3<u32>(u32(voxc_m4_4_4_m3_3_3_LEVEL_1_LOG2_CELL)));
    if (value == 0u) {
      voxc_m4_4_4_m3_3_3_step_over_emptyspan(ray, traversal, span);
    } else if (voxc_m4_4_4_m3_3_3_intersect_level_2(volume, ray, traversal, value)) {
      return true;
    }
  }
  return false;
}

// What a voxel is: here its value is its colour.
fn voxc_m4_4_4_m3_3_3_colour_of(traversal: voxc_m4_4_4_m3_3_3_Traversal) -> u32 { return traversal.voxel; }

