// ---- The format: D(7, 7, 7, 15) M(2, 2, 2) ----

// Level 2: masked, 4 x 4 x 4 cells of 1 voxel a side.
const voxc_d7_7_7_15_m2_2_2_LEVEL_2_LOG2_CELL: i32 = 0;

// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty,
// unless all are alike.

// The value of the cell that is not empty after so many others.
fn voxc_d7_7_7_15_m2_2_2_value_of_slot_level_2(volume: u32, grid: u32, slot: u32) -> u32 {
  return voxc_d7_7_7_15_m2_2_2_load_word(volume, grid + 2u + slot);
}

// The number of a cell's bit, of which each word of the mask has 32.
fn voxc_d7_7_7_15_m2_2_2_number_level_2(cell: vec3<i32>) -> i32 {
  return (cell.x & 3) | ((cell.y & 3) << 2u) | ((cell.z & 3) << 4u);
}

// The value of a cell that is not empty.
fn voxc_d7_7_7_15_m2_2_2_value_level_2(volume: u32, grid: u32, cell: vec3<i32>) -> u32 {
  let number = voxc_d7_7_7_15_m2_2_2_number_level_2(cell);
  let low = voxc_d7_7_7_15_m2_2_2_load_word(volume, grid);
  var half_mask: u32;
  if (number < 32) {
    half_mask = low;
  } else {
    half_mask = voxc_d7_7_7_15_m2_2_2_load_word(volume, grid + 1u);
  }
  let rank = i32(countOneBits(half_mask & ((1u << u32(number & 31)) - 1u))) + select(i32(countOneBits(low)), 0,
      number < 32);
  return voxc_d7_7_7_15_m2_2_2_value_of_slot_level_2(volume, grid, u32(rank));
}

// True if a cell is full. Else the empty span is as wide as the aligned group of eight cells around it, if they are all
// empty, or as the grid, if no cell is full that the ray may still come to.
fn voxc_d7_7_7_15_m2_2_2_is_full_level_2(volume: u32, grid: u32, cell: vec3<i32>, span: ptr<function,
    voxc_d7_7_7_15_m2_2_2_EmptySpan>) -> bool {
  let number = voxc_d7_7_7_15_m2_2_2_number_level_2(cell);
  // Half of the mask tells of the group. To know more of four voxels a side takes longer than the steps that it would
  // save.
  let half_mask = voxc_d7_7_7_15_m2_2_2_load_word(volume, grid + u32(number >> 5u));
  (*span).log2_side += select(0, 1, ((half_mask >> u32(number & 10)) & 0x00330033u) == 0u);
  return ((half_mask >> u32(number & 31)) & 1u) != 0u;
}

// The same, and the value of a cell that is full; 0 of one that is not.
fn voxc_d7_7_7_15_m2_2_2_look_up_level_2(volume: u32, grid: u32, cell: vec3<i32>, span: ptr<function,
    voxc_d7_7_7_15_m2_2_2_EmptySpan>) -> u32 {
  // Its value is looked up once it is hit.
  return select(0u, grid, voxc_d7_7_7_15_m2_2_2_is_full_level_2(volume, grid, cell, span));
}

// The faces ahead of what a mask may tell to be empty. They are made before it is known which of these it is, since the
// mask comes late: to choose is then all that is left to do.
fn voxc_d7_7_7_15_m2_2_2_faces_level_2(ray: voxc_d7_7_7_15_m2_2_2_Ray, cell: vec3<i32>,
    span: voxc_d7_7_7_15_m2_2_2_EmptySpan) -> vec3<f32> {
  let of_cell = vec3<f32>(voxc_d7_7_7_15_m2_2_2_faces_ahead(ray, cell,
      voxc_d7_7_7_15_m2_2_2_EmptySpan(voxc_d7_7_7_15_m2_2_2_LEVEL_2_LOG2_CELL, 1)));
  let of_group = vec3<f32>(voxc_d7_7_7_15_m2_2_2_faces_ahead(ray, cell,
      voxc_d7_7_7_15_m2_2_2_EmptySpan(voxc_d7_7_7_15_m2_2_2_LEVEL_2_LOG2_CELL + 1, 1)));
  return select(of_group, of_cell, span.log2_side == voxc_d7_7_7_15_m2_2_2_LEVEL_2_LOG2_CELL);
}

// The voxel around a cell, from this grid down; 0, and what is empty there with its faces ahead, if there is none.
fn voxc_d7_7_7_15_m2_2_2_locate_level_2(volume: u32, ray: voxc_d7_7_7_15_m2_2_2_Ray, grid: u32, cell: vec3<i32>,
    span: ptr<function, voxc_d7_7_7_15_m2_2_2_EmptySpan>, face: ptr<function, vec3<f32>>) -> u32 {
  *span = voxc_d7_7_7_15_m2_2_2_EmptySpan(voxc_d7_7_7_15_m2_2_2_LEVEL_2_LOG2_CELL, 1);
  let value = voxc_d7_7_7_15_m2_2_2_look_up_level_2(volume, grid,
      cell >> vec3<u32>(u32(voxc_d7_7_7_15_m2_2_2_LEVEL_2_LOG2_CELL)), span);
  if (value == 0u) {
    *face = voxc_d7_7_7_15_m2_2_2_faces_level_2(ray, cell, *span);
  }
  return value;
}

// Level 1: distance, 128 x 128 x 128 cells of 4 voxels a side.
const voxc_d7_7_7_15_m2_2_2_LEVEL_1_LOG2_SIZE: vec3<i32> = vec3<i32>(7, 7, 7);
const voxc_d7_7_7_15_m2_2_2_LEVEL_1_LOG2_CELL: i32 = 2;

// A grid has a slot a cell, x fastest, then y, then z.
// The place of a cell's slot: in that granule, where references count granules.
fn voxc_d7_7_7_15_m2_2_2_slot_level_1(grid: u32, cell: vec3<i32>) -> u32 {
  let at = cell;
  return grid + 2u * u32(at.x + ((at.y
      + (at.z << u32(voxc_d7_7_7_15_m2_2_2_LEVEL_1_LOG2_SIZE.y))) << u32(voxc_d7_7_7_15_m2_2_2_LEVEL_1_LOG2_SIZE.x)));
}

// The value of a cell, or 0 if it is empty; `span` then counts the cells of its distance.
fn voxc_d7_7_7_15_m2_2_2_look_up_level_1(volume: u32, ray: voxc_d7_7_7_15_m2_2_2_Ray, grid: u32, cell: vec3<i32>,
    span: ptr<function, voxc_d7_7_7_15_m2_2_2_EmptySpan>) -> u32 {
  let slot = voxc_d7_7_7_15_m2_2_2_slot_level_1(grid, cell);
  let word = voxc_d7_7_7_15_m2_2_2_load_word(volume, slot);
  // The distance stands behind the value.
  var skip: u32;
  if (word == 0u) {
    skip = voxc_d7_7_7_15_m2_2_2_load_word(volume, slot + 1u);
  } else {
    skip = 0u;
  }
  (*span).count = i32((skip >> u32(ray.octant * 4)) & 15u);
  return word;
}

// The voxel around a cell, from this grid down; 0, and what is empty there with its faces ahead, if there is none.
fn voxc_d7_7_7_15_m2_2_2_locate_level_1(volume: u32, ray: voxc_d7_7_7_15_m2_2_2_Ray, grid: u32, cell: vec3<i32>,
    span: ptr<function, voxc_d7_7_7_15_m2_2_2_EmptySpan>, face: ptr<function, vec3<f32>>) -> u32 {
  *span = voxc_d7_7_7_15_m2_2_2_EmptySpan(voxc_d7_7_7_15_m2_2_2_LEVEL_1_LOG2_CELL, 1);
  let value = voxc_d7_7_7_15_m2_2_2_look_up_level_1(volume, ray, grid,
      cell >> vec3<u32>(u32(voxc_d7_7_7_15_m2_2_2_LEVEL_1_LOG2_CELL)), span);
  if (value == 0u) {
    *face = vec3<f32>(voxc_d7_7_7_15_m2_2_2_faces_ahead(ray, cell, *span));
  }
  if (value == 0u) {
    return 0u;
  }
  return voxc_d7_7_7_15_m2_2_2_locate_level_2(volume, ray, value, cell, span, face);
}

// One loop. Each turn looks at the traversal's cell from the root on, through all levels.
fn voxc_d7_7_7_15_m2_2_2_intersect_level_1(volume: u32, ray: voxc_d7_7_7_15_m2_2_2_Ray, traversal: ptr<function,
    voxc_d7_7_7_15_m2_2_2_Traversal>, root: u32) -> bool {
  var before: vec3<i32> = (*traversal).cell;
  while (voxc_d7_7_7_15_m2_2_2_goes_on(*traversal)) {
    var span: voxc_d7_7_7_15_m2_2_2_EmptySpan = voxc_d7_7_7_15_m2_2_2_EmptySpan(0, 1);
    var face: vec3<f32> = vec3<f32>(0);
    let value = voxc_d7_7_7_15_m2_2_2_locate_level_1(volume, ray, root, (*traversal).cell, &span, &face);
    if (value != 0u) {
      (*traversal).voxel = value;
      return true;
    }
    before = (*traversal).cell;
    voxc_d7_7_7_15_m2_2_2_step_over(ray, traversal, span, face);
  }
  voxc_d7_7_7_15_m2_2_2_put_outside(traversal, before);
  return false;
}

// What a voxel is: here its value is its colour.
fn voxc_d7_7_7_15_m2_2_2_colour_of(volume: u32, traversal: voxc_d7_7_7_15_m2_2_2_Traversal) -> u32 {
  return voxc_d7_7_7_15_m2_2_2_value_level_2(volume, traversal.voxel, traversal.cell);
}

