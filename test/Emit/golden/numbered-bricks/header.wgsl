// ---- The format: M(2, 2, 2) M(2, 2, 2) M(2, 2, 2) ----

// The field of so many bits, 32 at most, whose first is that bit of those from a word of `begin` on.
fn voxc_m2_2_2_m2_2_2_m2_2_2_load_field_at(volume: u32, place: u32, first: u32, bits: u32) -> u32 {
  let low = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, place + (first >> 5u));
  let high = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, place + (first >> 5u) + 1u);
  let word = (low >> (first & 31u)) | ((high << 1u) << (31u - (first & 31u)));
  return select(word & ((1u << bits) - 1u), word, bits == 32u);
}

// Field i of those of so many bits that begin at a word.
fn voxc_m2_2_2_m2_2_2_m2_2_2_load_field(volume: u32, place: u32, i: u32, bits: u32) -> u32 {
  return voxc_m2_2_2_m2_2_2_m2_2_2_load_field_at(volume, place, i * bits, bits);
}

// Level 3: masked, 4 x 4 x 4 cells of 1 voxel a side.
const voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_3_LOG2_CELL: i32 = 0;

// Grids of 4 x 4 x 4 voxels stand in an array, and what leads to one is its number. A byte tells which of its octants
// of eight cells are not empty, and each of these has a byte of cells. Sixteen grids are a group, whose head has a word
// that tells at which byte of the array the cells of its first grid begin, and then the bytes of octants. All is in
// Morton order.

// Which octants of a grid are not empty, a bit for each, and the byte of the array at which their cells begin.
fn voxc_m2_2_2_m2_2_2_m2_2_2_octants_level_3(volume: u32, grid: u32, cells: ptr<function, u32>) -> u32 {
  let number = grid - 1u;
  let head = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, 2u) + 5u * (number >> 4u);
  let place = number & 15u;
  *cells = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, head);
  if (place > 3u) {
    *cells += countOneBits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, head + 1u));
  }
  if (place > 7u) {
    *cells += countOneBits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, head + 2u));
  }
  if (place > 11u) {
    *cells += countOneBits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, head + 3u));
  }
  let octants = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, head + 1u + (place >> 2u));
  let shift = 8u * (place & 3u);
  *cells += countOneBits(octants & ((1u << shift) - 1u));
  return (octants >> shift) & 255u;
}

// A byte of the array.
fn voxc_m2_2_2_m2_2_2_m2_2_2_byte_level_3(volume: u32, at: u32) -> u32 {
  return (voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume,
      2u) + (at >> 2u)) >> (8u * (at & 3u))) & 255u;
}

// The number of a place in 2 x 2 x 2, and a bit for each before it.
fn voxc_m2_2_2_m2_2_2_m2_2_2_place_level_3(place: vec3<i32>) -> i32 {
  return place.x | (place.y << 1u) | (place.z << 2u);
}
fn voxc_m2_2_2_m2_2_2_m2_2_2_before_level_3(place: vec3<i32>) -> u32 {
  return (1u << u32(voxc_m2_2_2_m2_2_2_m2_2_2_place_level_3(place))) - 1u;
}

// The cells of the octant around a cell, a bit for each: none if it is empty.
fn voxc_m2_2_2_m2_2_2_m2_2_2_octant_level_3(volume: u32, octants: u32, cells: u32, cell: vec3<i32>) -> u32 {
  let octant = (cell >> vec3<u32>(1u)) & vec3<i32>(1);
  if (((octants >> u32(voxc_m2_2_2_m2_2_2_m2_2_2_place_level_3(octant))) & 1u) == 0u) {
    return 0u;
  }
  return voxc_m2_2_2_m2_2_2_m2_2_2_byte_level_3(volume,
      cells + countOneBits(octants & voxc_m2_2_2_m2_2_2_m2_2_2_before_level_3(octant)));
}

// How many bits so many bytes of the array have, eight at most.
fn voxc_m2_2_2_m2_2_2_m2_2_2_bits_of_bytes_level_3(volume: u32, first: u32, bytes: u32) -> u32 {
  let array = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, 2u);
  let few = min(bytes, 4u);
  let bits = countOneBits(voxc_m2_2_2_m2_2_2_m2_2_2_load_field_at(volume, array, 8u * first, 8u * few));
  if (bytes > 4u) {
    return bits + countOneBits(voxc_m2_2_2_m2_2_2_m2_2_2_load_field_at(volume, array, 8u * first + 32u,
        8u * (bytes - few)));
  }
  return bits;
}

// How many voxels come before one.
fn voxc_m2_2_2_m2_2_2_m2_2_2_voxels_before_level_3(volume: u32, grid: u32, cell: vec3<i32>) -> u32 {
  var cells: u32;
  let octants = voxc_m2_2_2_m2_2_2_m2_2_2_octants_level_3(volume, grid, &cells);
  let lower = voxc_m2_2_2_m2_2_2_m2_2_2_octant_level_3(volume, octants, cells,
      cell) & voxc_m2_2_2_m2_2_2_m2_2_2_before_level_3(cell & vec3<i32>(1));
  let full = countOneBits(octants & voxc_m2_2_2_m2_2_2_m2_2_2_before_level_3((cell >> vec3<u32>(1u)) & vec3<i32>(1)));
  return voxc_m2_2_2_m2_2_2_m2_2_2_bits_of_bytes_level_3(volume, cells, full) + countOneBits(lower);
}

// How many voxels a grid has.
fn voxc_m2_2_2_m2_2_2_m2_2_2_voxels_level_3(volume: u32, grid: u32) -> u32 {
  var cells: u32;
  let octants = voxc_m2_2_2_m2_2_2_m2_2_2_octants_level_3(volume, grid, &cells);
  return voxc_m2_2_2_m2_2_2_m2_2_2_bits_of_bytes_level_3(volume, cells, countOneBits(octants));
}

// A bit for each place in 2 x 2 x 2 to which a ray may still come from one of them.
fn voxc_m2_2_2_m2_2_2_m2_2_2_ahead_level_3(ray: voxc_m2_2_2_m2_2_2_m2_2_2_Ray, place: vec3<i32>) -> u32 {
  let from_ = place & ray.ahead;
  let to = place | (ray.ahead & vec3<i32>(1));
  let sides = vec3<u32>((vec3<i32>(2) << vec3<u32>(to)) - (vec3<i32>(1) << vec3<u32>(from_)));
  return sides.x * ((sides.y & 1u) | ((sides.y & 2u) << 1u)) * ((sides.z & 1u) | ((sides.z & 2u) << 3u));
}

// True if a cell is full. Else the empty span is as wide as the octant around it, if that is empty, or as the grid, if
// nothing is full to which the ray may still come: neither a cell of the octant nor any of the other octants.
fn voxc_m2_2_2_m2_2_2_m2_2_2_is_full_level_3(volume: u32, ray: voxc_m2_2_2_m2_2_2_m2_2_2_Ray, grid: u32,
    cell: vec3<i32>, span: ptr<function, voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan>) -> bool {
  var cells: u32;
  let octants = voxc_m2_2_2_m2_2_2_m2_2_2_octants_level_3(volume, grid, &cells);
  let octant = (cell >> vec3<u32>(1u)) & vec3<i32>(1);
  let own = voxc_m2_2_2_m2_2_2_m2_2_2_octant_level_3(volume, octants, cells, cell);
  let others = octants & voxc_m2_2_2_m2_2_2_m2_2_2_ahead_level_3(ray,
      octant) & ~(1u << u32(voxc_m2_2_2_m2_2_2_m2_2_2_place_level_3(octant)));
  var around: i32 = select(0, 1, own == 0u);
  around = select(around, 2, (others | (own & voxc_m2_2_2_m2_2_2_m2_2_2_ahead_level_3(ray,
      cell & vec3<i32>(1)))) == 0u);
  (*span).log2_side += around;
  return ((own >> u32(voxc_m2_2_2_m2_2_2_m2_2_2_place_level_3(cell & vec3<i32>(1)))) & 1u) != 0u;
}

// The same, and the value of a cell that is full; 0 of one that is not.
fn voxc_m2_2_2_m2_2_2_m2_2_2_look_up_level_3(volume: u32, ray: voxc_m2_2_2_m2_2_2_m2_2_2_Ray, grid: u32,
    cell: vec3<i32>, span: ptr<function, voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan>) -> u32 {
  // Its value is looked up once it is hit.
  return select(0u, grid, voxc_m2_2_2_m2_2_2_m2_2_2_is_full_level_3(volume, ray, grid, cell, span));
}

// The faces ahead of what a mask may tell to be empty. They are made before it is known which of these it is, since the
// mask comes late: to choose is then all that is left to do.
fn voxc_m2_2_2_m2_2_2_m2_2_2_faces_level_3(ray: voxc_m2_2_2_m2_2_2_m2_2_2_Ray, cell: vec3<i32>,
    span: voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan) -> vec3<f32> {
  let of_cell = vec3<f32>(voxc_m2_2_2_m2_2_2_m2_2_2_faces_ahead(ray, cell,
      voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_3_LOG2_CELL, 1)));
  let of_group = vec3<f32>(voxc_m2_2_2_m2_2_2_m2_2_2_faces_ahead(ray, cell,
      voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_3_LOG2_CELL + 1, 1)));
  let of_grid = vec3<f32>(voxc_m2_2_2_m2_2_2_m2_2_2_faces_ahead(ray, cell,
      voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_3_LOG2_CELL + 2, 1)));
  return select(select(of_grid, of_group, span.log2_side == voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_3_LOG2_CELL + 1), of_cell,
      span.log2_side == voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_3_LOG2_CELL);
}

// The voxel around a cell, from this grid down; 0, and what is empty there with its faces ahead, if there is none.
fn voxc_m2_2_2_m2_2_2_m2_2_2_locate_level_3(volume: u32, ray: voxc_m2_2_2_m2_2_2_m2_2_2_Ray, grid: u32, cell: vec3<i32>,
    span: ptr<function, voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan>, face: ptr<function, vec3<f32>>) -> u32 {
  *span = voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_3_LOG2_CELL, 1);
  let value = voxc_m2_2_2_m2_2_2_m2_2_2_look_up_level_3(volume, ray, grid,
      cell >> vec3<u32>(u32(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_3_LOG2_CELL)), span);
  if (value == 0u) {
    *face = voxc_m2_2_2_m2_2_2_m2_2_2_faces_level_3(ray, cell, *span);
  }
  return value;
}

// Level 2: masked, 4 x 4 x 4 cells of 4 voxels a side.
const voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_SIZE: vec3<i32> = vec3<i32>(2, 2, 2);
const voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_CELL: i32 = 2;

// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty: each
// is the number of a sub-volume.

// How many cells that are not empty come before one.
fn voxc_m2_2_2_m2_2_2_m2_2_2_bits_before_level_2(volume: u32, grid: u32, cell: vec3<i32>) -> u32 {
  let at = cell & ((vec3<i32>(1) << vec3<u32>(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_SIZE)) - 1);
  let number = u32(at.x + ((at.y
      + (at.z << u32(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_SIZE.y))) << u32(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_SIZE.x)));
  let lower = (1u << (number & 31u)) - 1u;
  var before: u32;
  if (number < 32u) {
    before = 0u;
  } else {
    before = countOneBits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid));
  }
  return before + countOneBits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + (number >> 5u)) & lower);
}

// The value of the cell that is not empty after so many others.
fn voxc_m2_2_2_m2_2_2_m2_2_2_value_of_slot_level_2(volume: u32, grid: u32, slot: u32) -> u32 {
  return voxc_m2_2_2_m2_2_2_m2_2_2_load_field(volume, grid + 2u, slot, 12u);
}

// A bit for each octant of half a mask that is not empty: that of its first cell.
fn voxc_m2_2_2_m2_2_2_m2_2_2_octants_of_half_level_2(half_mask: u32) -> u32 {
  let bits = (half_mask | (half_mask >> 16u)) & 0xffffu;
  return (bits | (bits >> 1u) | (bits >> 4u) | (bits >> 5u)) & 0x0505u;
}

// How many voxels come before those of a cell, in Morton order: those before its octant of eight cells, which a count
// tells, and those of the cells before it there. The counts begin at a bit behind the mask.
fn voxc_m2_2_2_m2_2_2_m2_2_2_voxels_before_level_2(volume: u32, grid: u32, cell: vec3<i32>, counts: u32) -> u32 {
  let octant = (cell >> vec3<u32>(1u)) & vec3<i32>(1);
  let place = cell & vec3<i32>(1);
  let low = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid);
  var half_mask: u32;
  if (octant.z == 0) {
    half_mask = low;
  } else {
    half_mask = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + 1u);
  }
  let lower = select(low, 0u, octant.z == 0); // The half that comes before all of it.
  let first = 2 * octant.x + 8 * octant.y;
  let octants = (voxc_m2_2_2_m2_2_2_m2_2_2_octants_of_half_level_2(half_mask) & ((1u << u32(first)) - 1u))
      | (voxc_m2_2_2_m2_2_2_m2_2_2_octants_of_half_level_2(lower) << 16u);
  let earlier = countOneBits(octants);
  var before: u32 = 0u;
  if (earlier != 0u) {
    before = voxc_m2_2_2_m2_2_2_m2_2_2_load_field_at(volume, grid + 2u, counts + (earlier - 1u) * 12u, 12u);
  }
  var cells: u32 = (1u << u32(place.x | (place.y << 1u) | (place.z << 2u))) - 1u;
  cells = (cells | (cells << 12u)) & 0x000f000fu;
  cells = (cells | (cells << 2u)) & 0x00330033u;
  cells = (cells << u32(first)) & half_mask;
  while (cells != 0u) {
    let others = cells & (cells - 1u);
    let until = (cells ^ others) - 1u; // The bits below the lowest of the cells.
    let slot = u32(i32(countOneBits(lower)) + i32(countOneBits(half_mask & until)));
    let other = voxc_m2_2_2_m2_2_2_m2_2_2_value_of_slot_level_2(volume, grid, slot);
    before += voxc_m2_2_2_m2_2_2_m2_2_2_voxels_level_3(volume, other);
    cells = others;
  }
  return before;
}

// The value of a cell that is not empty. Adds to `rank` how many voxels of the grid come before those of the cell: in
// the bits behind all numbers that is told of each cell, or of each octant of cells but the first.
fn voxc_m2_2_2_m2_2_2_m2_2_2_ranked_value_level_2(volume: u32, grid: u32, cell: vec3<i32>, rank: ptr<function,
    u32>) -> u32 {
  let slot = voxc_m2_2_2_m2_2_2_m2_2_2_bits_before_level_2(volume, grid, cell);
  var slots: u32;
  slots = countOneBits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume,
      grid)) + countOneBits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + 1u));
  let counts = slots * 12u;
  *rank += voxc_m2_2_2_m2_2_2_m2_2_2_voxels_before_level_2(volume, grid, cell, counts);
  return voxc_m2_2_2_m2_2_2_m2_2_2_value_of_slot_level_2(volume, grid, slot);
}

// The number of a cell's bit, of which each word of the mask has 32.
fn voxc_m2_2_2_m2_2_2_m2_2_2_number_level_2(cell: vec3<i32>) -> i32 {
  return (cell.x & 3) | ((cell.y & 3) << 2u) | ((cell.z & 3) << 4u);
}

// The value of a cell that is not empty.
fn voxc_m2_2_2_m2_2_2_m2_2_2_value_level_2(volume: u32, grid: u32, cell: vec3<i32>) -> u32 {
  let number = voxc_m2_2_2_m2_2_2_m2_2_2_number_level_2(cell);
  let low = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid);
  var half_mask: u32;
  if (number < 32) {
    half_mask = low;
  } else {
    half_mask = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + 1u);
  }
  let rank = i32(countOneBits(half_mask & ((1u << u32(number & 31)) - 1u))) + select(i32(countOneBits(low)), 0,
      number < 32);
  return voxc_m2_2_2_m2_2_2_m2_2_2_value_of_slot_level_2(volume, grid, u32(rank));
}

// True if a cell is full. Else the empty span is as wide as the aligned group of eight cells around it, if they are all
// empty, or as the grid, if no cell is full that the ray may still come to.
fn voxc_m2_2_2_m2_2_2_m2_2_2_is_full_level_2(volume: u32, ray: voxc_m2_2_2_m2_2_2_m2_2_2_Ray, grid: u32,
    cell: vec3<i32>, span: ptr<function, voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan>) -> bool {
  let number = voxc_m2_2_2_m2_2_2_m2_2_2_number_level_2(cell);
  let low = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid);
  let high = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + 1u);
  let half_mask = select(high, low, number < 32);
  var around: i32 = select(0, 1, ((half_mask >> u32(number & 10)) & 0x00330033u) == 0u);
  // The rows, columns and planes from this cell on, a bit for each, and the 64 cells of which these are the sides.
  let at = cell & vec3<i32>(3);
  let from_ = at & ray.ahead;
  let to = at | (ray.ahead & vec3<i32>(3));
  let sides = vec3<u32>((vec3<i32>(2) << vec3<u32>(to)) - (vec3<i32>(1) << vec3<u32>(from_)));
  let plane = sides.x * ((sides.y & 1u) | ((sides.y & 2u) << 3u) | ((sides.y & 4u) << 6u) | ((sides.y & 8u) << 9u));
  let low_ahead = plane * ((sides.z & 1u) | ((sides.z & 2u) << 15u));
  let high_ahead = plane * (((sides.z >> 2u) & 1u) | ((sides.z & 8u) << 13u));
  around = select(around, 2, ((low & low_ahead) | (high & high_ahead)) == 0u);
  (*span).log2_side += around;
  return ((half_mask >> u32(number & 31)) & 1u) != 0u;
}

// The same, and the value of a cell that is full; 0 of one that is not.
fn voxc_m2_2_2_m2_2_2_m2_2_2_look_up_level_2(volume: u32, ray: voxc_m2_2_2_m2_2_2_m2_2_2_Ray, grid: u32,
    cell: vec3<i32>, span: ptr<function, voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan>) -> u32 {
  if (voxc_m2_2_2_m2_2_2_m2_2_2_is_full_level_2(volume, ray, grid, cell, span)) {
    return voxc_m2_2_2_m2_2_2_m2_2_2_value_level_2(volume, grid, cell);
  }
  return 0u;
}

// The faces ahead of what a mask may tell to be empty. They are made before it is known which of these it is, since the
// mask comes late: to choose is then all that is left to do.
fn voxc_m2_2_2_m2_2_2_m2_2_2_faces_level_2(ray: voxc_m2_2_2_m2_2_2_m2_2_2_Ray, cell: vec3<i32>,
    span: voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan) -> vec3<f32> {
  let of_cell = vec3<f32>(voxc_m2_2_2_m2_2_2_m2_2_2_faces_ahead(ray, cell,
      voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_CELL, 1)));
  let of_group = vec3<f32>(voxc_m2_2_2_m2_2_2_m2_2_2_faces_ahead(ray, cell,
      voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_CELL + 1, 1)));
  let of_grid = vec3<f32>(voxc_m2_2_2_m2_2_2_m2_2_2_faces_ahead(ray, cell,
      voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_CELL + 2, 1)));
  return select(select(of_grid, of_group, span.log2_side == voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_CELL + 1), of_cell,
      span.log2_side == voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_CELL);
}

// The voxel around a cell, from this grid down; 0, and what is empty there with its faces ahead, if there is none.
fn voxc_m2_2_2_m2_2_2_m2_2_2_locate_level_2(volume: u32, ray: voxc_m2_2_2_m2_2_2_m2_2_2_Ray, grid: u32, cell: vec3<i32>,
    span: ptr<function, voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan>, face: ptr<function, vec3<f32>>) -> u32 {
  *span = voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_CELL, 1);
  let value = voxc_m2_2_2_m2_2_2_m2_2_2_look_up_level_2(volume, ray, grid,
      cell >> vec3<u32>(u32(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_CELL)), span);
  if (value == 0u) {
    *face = voxc_m2_2_2_m2_2_2_m2_2_2_faces_level_2(ray, cell, *span);
  }
  if (value == 0u) {
    return 0u;
  }
  return voxc_m2_2_2_m2_2_2_m2_2_2_locate_level_3(volume, ray, value, cell, span, face);
}

// Level 1: masked, 4 x 4 x 4 cells of 16 voxels a side.
const voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_SIZE: vec3<i32> = vec3<i32>(2, 2, 2);
const voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_CELL: i32 = 4;

// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty,
// unless all are alike.

// How many cells that are not empty come before one.
fn voxc_m2_2_2_m2_2_2_m2_2_2_bits_before_level_1(volume: u32, grid: u32, cell: vec3<i32>) -> u32 {
  let at = cell & ((vec3<i32>(1) << vec3<u32>(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_SIZE)) - 1);
  let number = u32(at.x + ((at.y
      + (at.z << u32(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_SIZE.y))) << u32(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_SIZE.x)));
  let lower = (1u << (number & 31u)) - 1u;
  var before: u32;
  if (number < 32u) {
    before = 0u;
  } else {
    before = countOneBits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid));
  }
  return before + countOneBits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + (number >> 5u)) & lower);
}

// The value of the cell that is not empty after so many others.
fn voxc_m2_2_2_m2_2_2_m2_2_2_value_of_slot_level_1(volume: u32, grid: u32, slot: u32) -> u32 {
  return voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + 2u + 2u * slot);
}

// The value of a cell that is not empty. Adds to `rank` how many voxels of the grid come before those of the cell,
// which stands behind the value.
fn voxc_m2_2_2_m2_2_2_m2_2_2_ranked_value_level_1(volume: u32, grid: u32, cell: vec3<i32>, rank: ptr<function,
    u32>) -> u32 {
  let slot = voxc_m2_2_2_m2_2_2_m2_2_2_bits_before_level_1(volume, grid, cell);
  *rank += voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + 2u + 2u * slot + 1u);
  return voxc_m2_2_2_m2_2_2_m2_2_2_value_of_slot_level_1(volume, grid, slot);
}

// The number of a cell's bit, of which each word of the mask has 32.
fn voxc_m2_2_2_m2_2_2_m2_2_2_number_level_1(cell: vec3<i32>) -> i32 {
  return (cell.x & 3) | ((cell.y & 3) << 2u) | ((cell.z & 3) << 4u);
}

// The value of a cell that is not empty.
fn voxc_m2_2_2_m2_2_2_m2_2_2_value_level_1(volume: u32, grid: u32, cell: vec3<i32>) -> u32 {
  let number = voxc_m2_2_2_m2_2_2_m2_2_2_number_level_1(cell);
  let low = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid);
  var half_mask: u32;
  if (number < 32) {
    half_mask = low;
  } else {
    half_mask = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + 1u);
  }
  let rank = i32(countOneBits(half_mask & ((1u << u32(number & 31)) - 1u))) + select(i32(countOneBits(low)), 0,
      number < 32);
  return voxc_m2_2_2_m2_2_2_m2_2_2_value_of_slot_level_1(volume, grid, u32(rank));
}

// True if a cell is full. Else the empty span is as wide as the aligned group of eight cells around it, if they are all
// empty, or as the grid, if no cell is full that the ray may still come to.
fn voxc_m2_2_2_m2_2_2_m2_2_2_is_full_level_1(volume: u32, ray: voxc_m2_2_2_m2_2_2_m2_2_2_Ray, grid: u32,
    cell: vec3<i32>, span: ptr<function, voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan>) -> bool {
  let number = voxc_m2_2_2_m2_2_2_m2_2_2_number_level_1(cell);
  let low = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid);
  let high = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + 1u);
  let half_mask = select(high, low, number < 32);
  var around: i32 = select(0, 1, ((half_mask >> u32(number & 10)) & 0x00330033u) == 0u);
  // The rows, columns and planes from this cell on, a bit for each, and the 64 cells of which these are the sides.
  let at = cell & vec3<i32>(3);
  let from_ = at & ray.ahead;
  let to = at | (ray.ahead & vec3<i32>(3));
  let sides = vec3<u32>((vec3<i32>(2) << vec3<u32>(to)) - (vec3<i32>(1) << vec3<u32>(from_)));
  let plane = sides.x * ((sides.y & 1u) | ((sides.y & 2u) << 3u) | ((sides.y & 4u) << 6u) | ((sides.y & 8u) << 9u));
  let low_ahead = plane * ((sides.z & 1u) | ((sides.z & 2u) << 15u));
  let high_ahead = plane * (((sides.z >> 2u) & 1u) | ((sides.z & 8u) << 13u));
  around = select(around, 2, ((low & low_ahead) | (high & high_ahead)) == 0u);
  (*span).log2_side += around;
  return ((half_mask >> u32(number & 31)) & 1u) != 0u;
}

// The same, and the value of a cell that is full; 0 of one that is not.
fn voxc_m2_2_2_m2_2_2_m2_2_2_look_up_level_1(volume: u32, ray: voxc_m2_2_2_m2_2_2_m2_2_2_Ray, grid: u32,
    cell: vec3<i32>, span: ptr<function, voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan>) -> u32 {
  if (voxc_m2_2_2_m2_2_2_m2_2_2_is_full_level_1(volume, ray, grid, cell, span)) {
    return voxc_m2_2_2_m2_2_2_m2_2_2_value_level_1(volume, grid, cell);
  }
  return 0u;
}

// The faces ahead of what a mask may tell to be empty. They are made before it is known which of these it is, since the
// mask comes late: to choose is then all that is left to do.
fn voxc_m2_2_2_m2_2_2_m2_2_2_faces_level_1(ray: voxc_m2_2_2_m2_2_2_m2_2_2_Ray, cell: vec3<i32>,
    span: voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan) -> vec3<f32> {
  let of_cell = vec3<f32>(voxc_m2_2_2_m2_2_2_m2_2_2_faces_ahead(ray, cell,
      voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_CELL, 1)));
  let of_group = vec3<f32>(voxc_m2_2_2_m2_2_2_m2_2_2_faces_ahead(ray, cell,
      voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_CELL + 1, 1)));
  let of_grid = vec3<f32>(voxc_m2_2_2_m2_2_2_m2_2_2_faces_ahead(ray, cell,
      voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_CELL + 2, 1)));
  return select(select(of_grid, of_group, span.log2_side == voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_CELL + 1), of_cell,
      span.log2_side == voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_CELL);
}

// The voxel around a cell, from this grid down; 0, and what is empty there with its faces ahead, if there is none.
fn voxc_m2_2_2_m2_2_2_m2_2_2_locate_level_1(volume: u32, ray: voxc_m2_2_2_m2_2_2_m2_2_2_Ray, grid: u32, cell: vec3<i32>,
    span: ptr<function, voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan>, face: ptr<function, vec3<f32>>) -> u32 {
  *span = voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_CELL, 1);
  let value = voxc_m2_2_2_m2_2_2_m2_2_2_look_up_level_1(volume, ray, grid,
      cell >> vec3<u32>(u32(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_CELL)), span);
  if (value == 0u) {
    *face = voxc_m2_2_2_m2_2_2_m2_2_2_faces_level_1(ray, cell, *span);
  }
  if (value == 0u) {
    return 0u;
  }
  return voxc_m2_2_2_m2_2_2_m2_2_2_locate_level_2(volume, ray, value, cell, span, face);
}

// One loop. Each turn looks at the traversal's cell from the root on, through all levels.
fn voxc_m2_2_2_m2_2_2_m2_2_2_intersect_level_1(volume: u32, ray: voxc_m2_2_2_m2_2_2_m2_2_2_Ray, traversal: ptr<function,
    voxc_m2_2_2_m2_2_2_m2_2_2_Traversal>, root: u32) -> bool {
  var before: vec3<i32> = (*traversal).cell;
  while (voxc_m2_2_2_m2_2_2_m2_2_2_goes_on(*traversal)) {
    var span: voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan = voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(0, 1);
    var face: vec3<f32> = vec3<f32>(0);
    let value = voxc_m2_2_2_m2_2_2_m2_2_2_locate_level_1(volume, ray, root, (*traversal).cell, &span, &face);
    if (value != 0u) {
      return true;
    }
    before = (*traversal).cell;
    voxc_m2_2_2_m2_2_2_m2_2_2_step_over(ray, traversal, span, face);
  }
  voxc_m2_2_2_m2_2_2_m2_2_2_put_outside(traversal, before);
  return false;
}

// How many voxels of the grid come before one. Where traversals stop above voxels, one may not be there.
fn voxc_m2_2_2_m2_2_2_m2_2_2_rank_level_3(volume: u32, grid: u32, voxel: vec3<i32>) -> u32 {
  return voxc_m2_2_2_m2_2_2_m2_2_2_voxels_before_level_3(volume, grid, voxel);
}

// How many voxels of the grid come before one. Where traversals stop above voxels, one may not be there.
fn voxc_m2_2_2_m2_2_2_m2_2_2_rank_level_2(volume: u32, grid: u32, voxel: vec3<i32>) -> u32 {
  var rank: u32 = 0u;
  let value = voxc_m2_2_2_m2_2_2_m2_2_2_ranked_value_level_2(volume, grid,
      voxel >> vec3<u32>(u32(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_CELL)), &rank);
  return rank + voxc_m2_2_2_m2_2_2_m2_2_2_rank_level_3(volume, value, voxel);
}

// How many voxels of the grid come before one. Where traversals stop above voxels, one may not be there.
fn voxc_m2_2_2_m2_2_2_m2_2_2_rank_level_1(volume: u32, grid: u32, voxel: vec3<i32>) -> u32 {
  var rank: u32 = 0u;
  let value = voxc_m2_2_2_m2_2_2_m2_2_2_ranked_value_level_1(volume, grid,
      voxel >> vec3<u32>(u32(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_CELL)), &rank);
  return rank + voxc_m2_2_2_m2_2_2_m2_2_2_rank_level_2(volume, value, voxel);
}

// The values of voxels, by rank. Word 1 of the volume says where they begin: with a word for each block of 128, where
// that begins, then the blocks. A block is
//   the least of each channel;
//   4 bits a channel, how many bits it takes; DIFFERENCES; RUNS; the bits of an index; the word where the items begin;
//   with RUNS, 128 bits, set where a value is not that before it;
//   for each value, or run, the index of its item, if that has bits; the items.
const voxc_m2_2_2_m2_2_2_m2_2_2_LOG2_BLOCK: u32 = 7u;
const voxc_m2_2_2_m2_2_2_m2_2_2_DIFFERENCES: u32 = 1u << 16u; // R and B are told as their differences from G.
const voxc_m2_2_2_m2_2_2_m2_2_2_RUNS: u32 = 1u << 17u;
const voxc_m2_2_2_m2_2_2_m2_2_2_INDEX_SHIFT: u32 = 18u;
const voxc_m2_2_2_m2_2_2_m2_2_2_ITEMS_SHIFT: u32 = 24u;
const voxc_m2_2_2_m2_2_2_m2_2_2_HEAD_WORDS: u32 = 2u;
const voxc_m2_2_2_m2_2_2_m2_2_2_RUN_WORDS: u32 = 4u;

// How many of the bits at a word are set, up to bit i of the four words.
fn voxc_m2_2_2_m2_2_2_m2_2_2_runs_until(volume: u32, place: u32, i: u32) -> u32 {
  let last = i >> 5u;
  var begun: u32 = 0u;
  if (last > 0u) {
    begun += countOneBits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, place));
  }
  if (last > 1u) {
    begun += countOneBits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, place + 1u));
  }
  if (last > 2u) {
    begun += countOneBits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, place + 2u));
  }
  return begun + countOneBits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume,
      place + last) & (0xffffffffu >> (31u - (i & 31u))));
}

// A channel, whose bits begin at `shift` of an item and, in the head, 4 * channel up.
fn voxc_m2_2_2_m2_2_2_m2_2_2_channel_of(item: u32, shift: u32, least: u32, head: u32, channel: u32) -> u32 {
  let bits = (head >> (4u * channel)) & 15u;
  return (((item >> shift) & ((1u << bits) - 1u)) + (least >> (8u * channel))) & 255u;
}

fn voxc_m2_2_2_m2_2_2_m2_2_2_value_of_item(item: u32, least: u32, head: u32) -> u32 {
  let g_at = head & 15u;
  let b_at = g_at + ((head >> 4u) & 15u);
  let a_at = b_at + ((head >> 8u) & 15u);
  let r = voxc_m2_2_2_m2_2_2_m2_2_2_channel_of(item, 0u, least, head, 0u);
  let g = voxc_m2_2_2_m2_2_2_m2_2_2_channel_of(item, g_at, least, head, 1u);
  let b = voxc_m2_2_2_m2_2_2_m2_2_2_channel_of(item, b_at, least, head, 2u);
  let a = voxc_m2_2_2_m2_2_2_m2_2_2_channel_of(item, a_at, least, head, 3u);
  let from_ = select(0u, g, (head & voxc_m2_2_2_m2_2_2_m2_2_2_DIFFERENCES) != 0u);
  return ((r + from_) & 255u) | (g << 8u) | (((b + from_) & 255u) << 16u) | (a << 24u);
}

// The value of the voxel of a rank.
fn voxc_m2_2_2_m2_2_2_m2_2_2_value_of_rank(volume: u32, rank: u32) -> u32 {
  let section = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, 1u);
  let block = section + voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume,
      section + (rank >> voxc_m2_2_2_m2_2_2_m2_2_2_LOG2_BLOCK));
  let least = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, block);
  let head = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, block + 1u);
  var i: u32 = rank & ((1u << voxc_m2_2_2_m2_2_2_m2_2_2_LOG2_BLOCK) - 1u);
  var fields: u32 = block + voxc_m2_2_2_m2_2_2_m2_2_2_HEAD_WORDS;
  if ((head & voxc_m2_2_2_m2_2_2_m2_2_2_RUNS) != 0u) {
    i = voxc_m2_2_2_m2_2_2_m2_2_2_runs_until(volume, fields, i) - 1u;
    fields += voxc_m2_2_2_m2_2_2_m2_2_2_RUN_WORDS;
  }
  let index_bits = (head >> voxc_m2_2_2_m2_2_2_m2_2_2_INDEX_SHIFT) & 15u;
  if (index_bits != 0u) {
    i = voxc_m2_2_2_m2_2_2_m2_2_2_load_field(volume, fields, i, index_bits);
  }
  let bits = (head & 15u) + ((head >> 4u) & 15u) + ((head >> 8u) & 15u) + ((head >> 12u) & 15u);
  // Items without bits take no words, and a field is read with the word behind it: behind the last block is one word
  // alone.
  let items = select(0u, head >> voxc_m2_2_2_m2_2_2_m2_2_2_ITEMS_SHIFT, bits != 0u);
  return voxc_m2_2_2_m2_2_2_m2_2_2_value_of_item(voxc_m2_2_2_m2_2_2_m2_2_2_load_field(volume, block + items, i, bits),
      least, head);
}

// What a voxel is: here its value is its colour.
fn voxc_m2_2_2_m2_2_2_m2_2_2_colour_of(volume: u32, traversal: voxc_m2_2_2_m2_2_2_m2_2_2_Traversal) -> u32 {
  return voxc_m2_2_2_m2_2_2_m2_2_2_value_of_rank(volume, voxc_m2_2_2_m2_2_2_m2_2_2_rank_level_1(volume,
      voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, 0u), traversal.cell));
}

