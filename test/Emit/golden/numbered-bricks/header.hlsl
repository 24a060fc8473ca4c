// ---- The format: M(2, 2, 2) M(2, 2, 2) M(2, 2, 2) ----

// The field of so many bits, 32 at most, whose first is that bit of those from a word of `begin` on.
uint voxc_m2_2_2_m2_2_2_m2_2_2_load_field_at(VOXC_VOLUME volume, uint place, uint first, uint bits) {
  uint low = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, place + (first >> 5));
  uint high = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, place + (first >> 5) + 1u);
  uint word = low >> (first & 31u) | (high << 1) << (31u - (first & 31u));
  return bits == 32u ? word : word & ((1u << bits) - 1u);
}

// Field i of those of so many bits that begin at a word.
uint voxc_m2_2_2_m2_2_2_m2_2_2_load_field(VOXC_VOLUME volume, uint place, uint i, uint bits) {
  return voxc_m2_2_2_m2_2_2_m2_2_2_load_field_at(volume, place, i * bits, bits);
}

// Level 3: masked, 4 x 4 x 4 cells of 1 voxel a side.
static const int voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_3_LOG2_CELL = 0;

// Grids of 4 x 4 x 4 voxels stand in an array, and what leads to one is its number. A byte tells which of its octants
// of eight cells are not empty, and each of these has a byte of cells. Sixteen grids are a group, whose head has a word
// that tells at which byte of the array the cells of its first grid begin, and then the bytes of octants. All is in
// Morton order.

// Which octants of a grid are not empty, a bit for each, and the byte of the array at which their cells begin.
uint voxc_m2_2_2_m2_2_2_m2_2_2_octants_level_3(VOXC_VOLUME volume, uint grid, out uint cells) {
  uint number = grid - 1u;
  uint head = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, 2u) + 5u * (number >> 4);
  uint place = number & 15u;
  cells = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, head);
  if (place > 3u)
    cells += uint(int(countbits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, head + 1u))));
  if (place > 7u)
    cells += uint(int(countbits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, head + 2u))));
  if (place > 11u)
    cells += uint(int(countbits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, head + 3u))));
  uint octants = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, head + 1u + (place >> 2));
  uint shift = 8u * (place & 3u);
  cells += uint(int(countbits(octants & ((1u << shift) - 1u))));
  return octants >> shift & 255u;
}

// A byte of the array.
uint voxc_m2_2_2_m2_2_2_m2_2_2_byte_level_3(VOXC_VOLUME volume, uint at) {
  return voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume,
      2u) + (at >> 2)) >> 8u * (at & 3u) & 255u;
}

// The number of a place in 2 x 2 x 2, and a bit for each before it.
int voxc_m2_2_2_m2_2_2_m2_2_2_place_level_3(int3 place) { return place.x | place.y << 1 | place.z << 2; }
uint voxc_m2_2_2_m2_2_2_m2_2_2_before_level_3(int3 place) {
  return (1u << voxc_m2_2_2_m2_2_2_m2_2_2_place_level_3(place)) - 1u;
}

// The cells of the octant around a cell, a bit for each: none if it is empty.
uint voxc_m2_2_2_m2_2_2_m2_2_2_octant_level_3(VOXC_VOLUME volume, uint octants, uint cells, int3 cell) {
  int3 octant = cell >> 1 & 1;
  if ((octants >> voxc_m2_2_2_m2_2_2_m2_2_2_place_level_3(octant) & 1u) == 0u)
    return 0u;
  return voxc_m2_2_2_m2_2_2_m2_2_2_byte_level_3(volume,
      cells + uint(int(countbits(octants & voxc_m2_2_2_m2_2_2_m2_2_2_before_level_3(octant)))));
}

// How many bits so many bytes of the array have, eight at most.
uint voxc_m2_2_2_m2_2_2_m2_2_2_bits_of_bytes_level_3(VOXC_VOLUME volume, uint first, uint bytes) {
  uint array = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, 2u);
  uint few = min(bytes, 4u);
  uint bits = uint(int(countbits(voxc_m2_2_2_m2_2_2_m2_2_2_load_field_at(volume, array, 8u * first, 8u * few))));
  return bytes > 4u ? bits + uint(int(countbits(voxc_m2_2_2_m2_2_2_m2_2_2_load_field_at(volume, array, 8u * first + 32u,
      8u * (bytes - few))))) : bits;
}

// How many voxels come before one.
uint voxc_m2_2_2_m2_2_2_m2_2_2_voxels_before_level_3(VOXC_VOLUME volume, uint grid, int3 cell) {
  uint cells;
  uint octants = voxc_m2_2_2_m2_2_2_m2_2_2_octants_level_3(volume, grid, cells);
  uint lower = voxc_m2_2_2_m2_2_2_m2_2_2_octant_level_3(volume, octants, cells,
      cell) & voxc_m2_2_2_m2_2_2_m2_2_2_before_level_3(cell & 1);
  uint full = uint(int(countbits(octants & voxc_m2_2_2_m2_2_2_m2_2_2_before_level_3(cell >> 1 & 1))));
  return voxc_m2_2_2_m2_2_2_m2_2_2_bits_of_bytes_level_3(volume, cells, full) + uint(int(countbits(lower)));
}

// How many voxels a grid has.
uint voxc_m2_2_2_m2_2_2_m2_2_2_voxels_level_3(VOXC_VOLUME volume, uint grid) {
  uint cells;
  uint octants = voxc_m2_2_2_m2_2_2_m2_2_2_octants_level_3(volume, grid, cells);
  return voxc_m2_2_2_m2_2_2_m2_2_2_bits_of_bytes_level_3(volume, cells, uint(int(countbits(octants))));
}

// A bit for each place in 2 x 2 x 2 to which a ray may still come from one of them.
uint voxc_m2_2_2_m2_2_2_m2_2_2_ahead_level_3(const voxc_m2_2_2_m2_2_2_m2_2_2_Ray ray, int3 place) {
  int3 from = place & ray.ahead;
  int3 to = place | (ray.ahead & 1);
  uint3 sides = uint3(((int3)2 << to) - ((int3)1 << from));
  return sides.x * (sides.y & 1u | (sides.y & 2u) << 1) * (sides.z & 1u | (sides.z & 2u) << 3);
}

// True if a cell is full. Else the empty span is as wide as the octant around it, if that is empty, or as the grid, if
// nothing is full to which the ray may still come: neither a cell of the octant nor any of the other octants.
bool voxc_m2_2_2_m2_2_2_m2_2_2_is_full_level_3(VOXC_VOLUME volume, const voxc_m2_2_2_m2_2_2_m2_2_2_Ray ray, uint grid,
    int3 cell, inout voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan span) {
  uint cells;
  uint octants = voxc_m2_2_2_m2_2_2_m2_2_2_octants_level_3(volume, grid, cells);
  int3 octant = cell >> 1 & 1;
  uint own = voxc_m2_2_2_m2_2_2_m2_2_2_octant_level_3(volume, octants, cells, cell);
  uint others = octants & voxc_m2_2_2_m2_2_2_m2_2_2_ahead_level_3(ray,
      octant) & ~(1u << voxc_m2_2_2_m2_2_2_m2_2_2_place_level_3(octant));
  int around = own == 0u ? 1 : 0;
  around = (others | (own & voxc_m2_2_2_m2_2_2_m2_2_2_ahead_level_3(ray, cell & 1))) == 0u ? 2 : around;
  span.log2_side += around;
  return (own >> voxc_m2_2_2_m2_2_2_m2_2_2_place_level_3(cell & 1) & 1u) != 0u;
}

// The same, and the value of a cell that is full; 0 of one that is not.
uint voxc_m2_2_2_m2_2_2_m2_2_2_look_up_level_3(VOXC_VOLUME volume, const voxc_m2_2_2_m2_2_2_m2_2_2_Ray ray, uint grid,
    int3 cell, inout voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan span) {
  // Its value is looked up once it is hit.
  return voxc_m2_2_2_m2_2_2_m2_2_2_is_full_level_3(volume, ray, grid, cell, span) ? grid : 0u;
}

// The faces ahead of what a mask may tell to be empty. They are made before it is known which of these it is, since the
// mask comes late: to choose is then all that is left to do.
float3 voxc_m2_2_2_m2_2_2_m2_2_2_faces_level_3(const voxc_m2_2_2_m2_2_2_m2_2_2_Ray ray, int3 cell,
    const voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan span) {
  float3 of_cell = float3(voxc_m2_2_2_m2_2_2_m2_2_2_faces_ahead(ray, cell,
      make_voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_3_LOG2_CELL, 1)));
  float3 of_group = float3(voxc_m2_2_2_m2_2_2_m2_2_2_faces_ahead(ray, cell,
      make_voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_3_LOG2_CELL + 1, 1)));
  float3 of_grid = float3(voxc_m2_2_2_m2_2_2_m2_2_2_faces_ahead(ray, cell,
      make_voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_3_LOG2_CELL + 2, 1)));
  return span.log2_side == voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_3_LOG2_CELL ? of_cell
      : span.log2_side == voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_3_LOG2_CELL + 1 ? of_group : of_grid;
}

// The voxel around a cell, from this grid down; 0, and what is empty there with its faces ahead, if there is none.
uint voxc_m2_2_2_m2_2_2_m2_2_2_locate_level_3(VOXC_VOLUME volume, const voxc_m2_2_2_m2_2_2_m2_2_2_Ray ray, uint grid,
    int3 cell, inout voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan span, inout float3 face) {
  span = make_voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_3_LOG2_CELL, 1);
  uint value = voxc_m2_2_2_m2_2_2_m2_2_2_look_up_level_3(volume, ray, grid,
      cell >> voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_3_LOG2_CELL, span);
  if (value == 0u)
    face = voxc_m2_2_2_m2_2_2_m2_2_2_faces_level_3(ray, cell, span);
  return value;
}

// Level 2: masked, 4 x 4 x 4 cells of 4 voxels a side.
static const int3 voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_SIZE = int3(2, 2, 2);
static const int voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_CELL = 2;

// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty: each
// is the number of a sub-volume.

// How many cells that are not empty come before one.
uint voxc_m2_2_2_m2_2_2_m2_2_2_bits_before_level_2(VOXC_VOLUME volume, uint grid, int3 cell) {
  int3 at = cell & (((int3)1 << voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_SIZE) - 1);
  uint number = uint(at.x + ((at.y
      + (at.z << voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_SIZE.y)) << voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_SIZE.x));
  uint lower = (1u << (number & 31u)) - 1u;
  uint before = number < 32u ? 0u : uint(int(countbits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid))));
  return before + uint(int(countbits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + (number >> 5)) & lower)));
}

// The value of the cell that is not empty after so many others.
uint voxc_m2_2_2_m2_2_2_m2_2_2_value_of_slot_level_2(VOXC_VOLUME volume, uint grid, uint slot) {
  return voxc_m2_2_2_m2_2_2_m2_2_2_load_field(volume, grid + 2u, slot, 12u);
}

// A bit for each octant of half a mask that is not empty: that of its first cell.
uint voxc_m2_2_2_m2_2_2_m2_2_2_octants_of_half_level_2(uint half_mask) {
  uint bits = (half_mask | half_mask >> 16) & 0xffffu;
  return (bits | bits >> 1 | bits >> 4 | bits >> 5) & 0x0505u;
}

// How many voxels come before those of a cell, in Morton order: those before its octant of eight cells, which a count
// tells, and those of the cells before it there. The counts begin at a bit behind the mask.
uint voxc_m2_2_2_m2_2_2_m2_2_2_voxels_before_level_2(VOXC_VOLUME volume, uint grid, int3 cell, uint counts) {
  int3 octant = cell >> 1 & 1;
  int3 place = cell & 1;
  uint low = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid);
  uint half_mask = octant.z == 0 ? low : voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + 1u);
  uint lower = octant.z == 0 ? 0u : low; // The half that comes before all of it.
  int first = 2 * octant.x + 8 * octant.y;
  uint octants = voxc_m2_2_2_m2_2_2_m2_2_2_octants_of_half_level_2(half_mask) & ((1u << first) - 1u)
      | voxc_m2_2_2_m2_2_2_m2_2_2_octants_of_half_level_2(lower) << 16;
  uint earlier = uint(int(countbits(octants)));
  uint before = 0u;
  if (earlier != 0u)
    before = voxc_m2_2_2_m2_2_2_m2_2_2_load_field_at(volume, grid + 2u, counts + (earlier - 1u) * 12u, 12u);
  uint cells = (1u << (place.x | place.y << 1 | place.z << 2)) - 1u;
  cells = (cells | cells << 12) & 0x000f000fu;
  cells = (cells | cells << 2) & 0x00330033u;
  cells = cells << first & half_mask;
  while (cells != 0u) {
    uint others = cells & (cells - 1u);
    uint until = (cells ^ others) - 1u; // The bits below the lowest of the cells.
    uint slot = uint(int(countbits(lower)) + int(countbits(half_mask & until)));
    uint other = voxc_m2_2_2_m2_2_2_m2_2_2_value_of_slot_level_2(volume, grid, slot);
    before += voxc_m2_2_2_m2_2_2_m2_2_2_voxels_level_3(volume, other);
    cells = others;
  }
  return before;
}

// The value of a cell that is not empty. Adds to `rank` how many voxels of the grid come before those of the cell: in
// the bits behind all numbers that is told of each cell, or of each octant of cells but the first.
uint voxc_m2_2_2_m2_2_2_m2_2_2_ranked_value_level_2(VOXC_VOLUME volume, uint grid, int3 cell, inout uint rank) {
  uint slot = voxc_m2_2_2_m2_2_2_m2_2_2_bits_before_level_2(volume, grid, cell);
  uint slots;
  slots = uint(int(countbits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume,
      grid)))) + uint(int(countbits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + 1u))));
  uint counts = slots * 12u;
  rank += voxc_m2_2_2_m2_2_2_m2_2_2_voxels_before_level_2(volume, grid, cell, counts);
  return voxc_m2_2_2_m2_2_2_m2_2_2_value_of_slot_level_2(volume, grid, slot);
}

// The number of a cell's bit, of which each word of the mask has 32.
int voxc_m2_2_2_m2_2_2_m2_2_2_number_level_2(int3 cell) { return (cell.x & 3) | (cell.y & 3) << 2 | (cell.z & 3) << 4; }

// The value of a cell that is not empty.
uint voxc_m2_2_2_m2_2_2_m2_2_2_value_level_2(VOXC_VOLUME volume, uint grid, int3 cell) {
  int number = voxc_m2_2_2_m2_2_2_m2_2_2_number_level_2(cell);
  uint low = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid);
  uint half_mask = number < 32 ? low : voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + 1u);
  int rank = int(countbits(half_mask & ((1u << (number & 31)) - 1u))) + (number < 32 ? 0 : int(countbits(low)));
  return voxc_m2_2_2_m2_2_2_m2_2_2_value_of_slot_level_2(volume, grid, uint(rank));
}

// True if a cell is full. Else the empty span is as wide as the aligned group of eight cells around it, if they are all
// empty, or as the grid, if no cell is full that the ray may still come to.
bool voxc_m2_2_2_m2_2_2_m2_2_2_is_full_level_2(VOXC_VOLUME volume, const voxc_m2_2_2_m2_2_2_m2_2_2_Ray ray, uint grid,
    int3 cell, inout voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan span) {
  int number = voxc_m2_2_2_m2_2_2_m2_2_2_number_level_2(cell);
  uint low = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid);
  uint high = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + 1u);
  uint half_mask = number < 32 ? low : high;
  int around = (half_mask >> (number & 10) & 0x00330033u) == 0u ? 1 : 0;
  // The rows, columns and planes from this cell on, a bit for each, and the 64 cells of which these are the sides.
  int3 at = cell & 3;
  int3 from = at & ray.ahead;
  int3 to = at | (ray.ahead & 3);
  uint3 sides = uint3(((int3)2 << to) - ((int3)1 << from));
  uint plane = sides.x * (sides.y & 1u | (sides.y & 2u) << 3 | (sides.y & 4u) << 6 | (sides.y & 8u) << 9);
  uint low_ahead = plane * (sides.z & 1u | (sides.z & 2u) << 15);
  uint high_ahead = plane * (sides.z >> 2 & 1u | (sides.z & 8u) << 13);
  around = ((low & low_ahead) | (high & high_ahead)) == 0u ? 2 : around;
  span.log2_side += around;
  return (half_mask >> (number & 31) & 1u) != 0u;
}

// The same, and the value of a cell that is full; 0 of one that is not.
uint voxc_m2_2_2_m2_2_2_m2_2_2_look_up_level_2(VOXC_VOLUME volume, const voxc_m2_2_2_m2_2_2_m2_2_2_Ray ray, uint grid,
    int3 cell, inout voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan span) {
  return voxc_m2_2_2_m2_2_2_m2_2_2_is_full_level_2(volume, ray, grid, cell,
      span) ? voxc_m2_2_2_m2_2_2_m2_2_2_value_level_2(volume, grid, cell) : 0u;
}

// The faces ahead of what a mask may tell to be empty. They are made before it is known which of these it is, since the
// mask comes late: to choose is then all that is left to do.
float3 voxc_m2_2_2_m2_2_2_m2_2_2_faces_level_2(const voxc_m2_2_2_m2_2_2_m2_2_2_Ray ray, int3 cell,
    const voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan span) {
  float3 of_cell = float3(voxc_m2_2_2_m2_2_2_m2_2_2_faces_ahead(ray, cell,
      make_voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_CELL, 1)));
  float3 of_group = float3(voxc_m2_2_2_m2_2_2_m2_2_2_faces_ahead(ray, cell,
      make_voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_CELL + 1, 1)));
  float3 of_grid = float3(voxc_m2_2_2_m2_2_2_m2_2_2_faces_ahead(ray, cell,
      make_voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_CELL + 2, 1)));
  return span.log2_side == voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_CELL ? of_cell
      : span.log2_side == voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_CELL + 1 ? of_group : of_grid;
}

// The voxel around a cell, from this grid down; 0, and what is empty there with its faces ahead, if there is none.
uint voxc_m2_2_2_m2_2_2_m2_2_2_locate_level_2(VOXC_VOLUME volume, const voxc_m2_2_2_m2_2_2_m2_2_2_Ray ray, uint grid,
    int3 cell, inout voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan span, inout float3 face) {
  span = make_voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_CELL, 1);
  uint value = voxc_m2_2_2_m2_2_2_m2_2_2_look_up_level_2(volume, ray, grid,
      cell >> voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_CELL, span);
  if (value == 0u)
    face = voxc_m2_2_2_m2_2_2_m2_2_2_faces_level_2(ray, cell, span);
  if (value == 0u)
    return 0u;
  return voxc_m2_2_2_m2_2_2_m2_2_2_locate_level_3(volume, ray, value, cell, span, face);
}

// Level 1: masked, 4 x 4 x 4 cells of 16 voxels a side.
static const int3 voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_SIZE = int3(2, 2, 2);
static const int voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_CELL = 4;

// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty,
// unless all are alike.

// How many cells that are not empty come before one.
uint voxc_m2_2_2_m2_2_2_m2_2_2_bits_before_level_1(VOXC_VOLUME volume, uint grid, int3 cell) {
  int3 at = cell & (((int3)1 << voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_SIZE) - 1);
  uint number = uint(at.x + ((at.y
      + (at.z << voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_SIZE.y)) << voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_SIZE.x));
  uint lower = (1u << (number & 31u)) - 1u;
  uint before = number < 32u ? 0u : uint(int(countbits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid))));
  return before + uint(int(countbits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + (number >> 5)) & lower)));
}

// The value of the cell that is not empty after so many others.
uint voxc_m2_2_2_m2_2_2_m2_2_2_value_of_slot_level_1(VOXC_VOLUME volume, uint grid, uint slot) {
  return voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + 2u + 2u * slot);
}

// The value of a cell that is not empty. Adds to `rank` how many voxels of the grid come before those of the cell,
// which stands behind the value.
uint voxc_m2_2_2_m2_2_2_m2_2_2_ranked_value_level_1(VOXC_VOLUME volume, uint grid, int3 cell, inout uint rank) {
  uint slot = voxc_m2_2_2_m2_2_2_m2_2_2_bits_before_level_1(volume, grid, cell);
  rank += voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + 2u + 2u * slot + 1u);
  return voxc_m2_2_2_m2_2_2_m2_2_2_value_of_slot_level_1(volume, grid, slot);
}

// The number of a cell's bit, of which each word of the mask has 32.
int voxc_m2_2_2_m2_2_2_m2_2_2_number_level_1(int3 cell) { return (cell.x & 3) | (cell.y & 3) << 2 | (cell.z & 3) << 4; }

// The value of a cell that is not empty.
uint voxc_m2_2_2_m2_2_2_m2_2_2_value_level_1(VOXC_VOLUME volume, uint grid, int3 cell) {
  int number = voxc_m2_2_2_m2_2_2_m2_2_2_number_level_1(cell);
  uint low = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid);
  uint half_mask = number < 32 ? low : voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + 1u);
  int rank = int(countbits(half_mask & ((1u << (number & 31)) - 1u))) + (number < 32 ? 0 : int(countbits(low)));
  return voxc_m2_2_2_m2_2_2_m2_2_2_value_of_slot_level_1(volume, grid, uint(rank));
}

// True if a cell is full. Else the empty span is as wide as the aligned group of eight cells around it, if they are all
// empty, or as the grid, if no cell is full that the ray may still come to.
bool voxc_m2_2_2_m2_2_2_m2_2_2_is_full_level_1(VOXC_VOLUME volume, const voxc_m2_2_2_m2_2_2_m2_2_2_Ray ray, uint grid,
    int3 cell, inout voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan span) {
  int number = voxc_m2_2_2_m2_2_2_m2_2_2_number_level_1(cell);
  uint low = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid);
  uint high = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, grid + 1u);
  uint half_mask = number < 32 ? low : high;
  int around = (half_mask >> (number & 10) & 0x00330033u) == 0u ? 1 : 0;
  // The rows, columns and planes from this cell on, a bit for each, and the 64 cells of which these are the sides.
  int3 at = cell & 3;
  int3 from = at & ray.ahead;
  int3 to = at | (ray.ahead & 3);
  uint3 sides = uint3(((int3)2 << to) - ((int3)1 << from));
  uint plane = sides.x * (sides.y & 1u | (sides.y & 2u) << 3 | (sides.y & 4u) << 6 | (sides.y & 8u) << 9);
  uint low_ahead = plane * (sides.z & 1u | (sides.z & 2u) << 15);
  uint high_ahead = plane * (sides.z >> 2 & 1u | (sides.z & 8u) << 13);
  around = ((low & low_ahead) | (high & high_ahead)) == 0u ? 2 : around;
  span.log2_side += around;
  return (half_mask >> (number & 31) & 1u) != 0u;
}

// The same, and the value of a cell that is full; 0 of one that is not.
uint voxc_m2_2_2_m2_2_2_m2_2_2_look_up_level_1(VOXC_VOLUME volume, const voxc_m2_2_2_m2_2_2_m2_2_2_Ray ray, uint grid,
    int3 cell, inout voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan span) {
  return voxc_m2_2_2_m2_2_2_m2_2_2_is_full_level_1(volume, ray, grid, cell,
      span) ? voxc_m2_2_2_m2_2_2_m2_2_2_value_level_1(volume, grid, cell) : 0u;
}

// The faces ahead of what a mask may tell to be empty. They are made before it is known which of these it is, since the
// mask comes late: to choose is then all that is left to do.
float3 voxc_m2_2_2_m2_2_2_m2_2_2_faces_level_1(const voxc_m2_2_2_m2_2_2_m2_2_2_Ray ray, int3 cell,
    const voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan span) {
  float3 of_cell = float3(voxc_m2_2_2_m2_2_2_m2_2_2_faces_ahead(ray, cell,
      make_voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_CELL, 1)));
  float3 of_group = float3(voxc_m2_2_2_m2_2_2_m2_2_2_faces_ahead(ray, cell,
      make_voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_CELL + 1, 1)));
  float3 of_grid = float3(voxc_m2_2_2_m2_2_2_m2_2_2_faces_ahead(ray, cell,
      make_voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_CELL + 2, 1)));
  return span.log2_side == voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_CELL ? of_cell
      : span.log2_side == voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_CELL + 1 ? of_group : of_grid;
}

// The voxel around a cell, from this grid down; 0, and what is empty there with its faces ahead, if there is none.
uint voxc_m2_2_2_m2_2_2_m2_2_2_locate_level_1(VOXC_VOLUME volume, const voxc_m2_2_2_m2_2_2_m2_2_2_Ray ray, uint grid,
    int3 cell, inout voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan span, inout float3 face) {
  span = make_voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_CELL, 1);
  uint value = voxc_m2_2_2_m2_2_2_m2_2_2_look_up_level_1(volume, ray, grid,
      cell >> voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_CELL, span);
  if (value == 0u)
    face = voxc_m2_2_2_m2_2_2_m2_2_2_faces_level_1(ray, cell, span);
  if (value == 0u)
    return 0u;
  return voxc_m2_2_2_m2_2_2_m2_2_2_locate_level_2(volume, ray, value, cell, span, face);
}

// One loop. Each turn looks at the traversal's cell from the root on, through all levels.
bool voxc_m2_2_2_m2_2_2_m2_2_2_intersect_level_1(VOXC_VOLUME volume, const voxc_m2_2_2_m2_2_2_m2_2_2_Ray ray,
    inout voxc_m2_2_2_m2_2_2_m2_2_2_Traversal traversal, uint root) {
  int3 before = traversal.cell;
  while (voxc_m2_2_2_m2_2_2_m2_2_2_goes_on(traversal)) {
    voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan span = make_voxc_m2_2_2_m2_2_2_m2_2_2_EmptySpan(0, 1);
    float3 face = (float3)0;
    uint value = voxc_m2_2_2_m2_2_2_m2_2_2_locate_level_1(volume, ray, root, traversal.cell, span, face);
    if (value != 0u) {
      return true;
    }
    before = traversal.cell;
    voxc_m2_2_2_m2_2_2_m2_2_2_step_over(ray, traversal, span, face);
  }
  voxc_m2_2_2_m2_2_2_m2_2_2_put_outside(traversal, before);
  return false;
}

// How many voxels of the grid come before one. Where traversals stop above voxels, one may not be there.
uint voxc_m2_2_2_m2_2_2_m2_2_2_rank_level_3(VOXC_VOLUME volume, uint grid, int3 voxel) {
  return voxc_m2_2_2_m2_2_2_m2_2_2_voxels_before_level_3(volume, grid, voxel);
}

// How many voxels of the grid come before one. Where traversals stop above voxels, one may not be there.
uint voxc_m2_2_2_m2_2_2_m2_2_2_rank_level_2(VOXC_VOLUME volume, uint grid, int3 voxel) {
  uint rank = 0u;
  uint value = voxc_m2_2_2_m2_2_2_m2_2_2_ranked_value_level_2(volume, grid,
      voxel >> voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_2_LOG2_CELL, rank);
  return rank + voxc_m2_2_2_m2_2_2_m2_2_2_rank_level_3(volume, value, voxel);
}

// How many voxels of the grid come before one. Where traversals stop above voxels, one may not be there.
uint voxc_m2_2_2_m2_2_2_m2_2_2_rank_level_1(VOXC_VOLUME volume, uint grid, int3 voxel) {
  uint rank = 0u;
  uint value = voxc_m2_2_2_m2_2_2_m2_2_2_ranked_value_level_1(volume, grid,
      voxel >> voxc_m2_2_2_m2_2_2_m2_2_2_LEVEL_1_LOG2_CELL, rank);
  return rank + voxc_m2_2_2_m2_2_2_m2_2_2_rank_level_2(volume, value, voxel);
}

// The values of voxels, by rank. Word 1 of the volume says where they begin: with a word for each block of 128, where
// that begins, then the blocks. A block is
//   the least of each channel;
//   4 bits a channel, how many bits it takes; DIFFERENCES; RUNS; the bits of an index; the word where the items begin;
//   with RUNS, 128 bits, set where a value is not that before it;
//   for each value, or run, the index of its item, if that has bits; the items.
static const uint voxc_m2_2_2_m2_2_2_m2_2_2_LOG2_BLOCK = 7u;
static const uint voxc_m2_2_2_m2_2_2_m2_2_2_DIFFERENCES = 1u << 16; // R and B are told as their differences from G.
static const uint voxc_m2_2_2_m2_2_2_m2_2_2_RUNS = 1u << 17;
static const uint voxc_m2_2_2_m2_2_2_m2_2_2_INDEX_SHIFT = 18u;
static const uint voxc_m2_2_2_m2_2_2_m2_2_2_ITEMS_SHIFT = 24u;
static const uint voxc_m2_2_2_m2_2_2_m2_2_2_HEAD_WORDS = 2u;
static const uint voxc_m2_2_2_m2_2_2_m2_2_2_RUN_WORDS = 4u;

// How many of the bits at a word are set, up to bit i of the four words.
uint voxc_m2_2_2_m2_2_2_m2_2_2_runs_until(VOXC_VOLUME volume, uint place, uint i) {
  uint last = i >> 5;
  uint begun = 0u;
  if (last > 0u)
    begun += uint(int(countbits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, place))));
  if (last > 1u)
    begun += uint(int(countbits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, place + 1u))));
  if (last > 2u)
    begun += uint(int(countbits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, place + 2u))));
  return begun + uint(int(countbits(voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume,
      place + last) & (0xffffffffu >> (31u - (i & 31u))))));
}

// A channel, whose bits begin at `shift` of an item and, in the head, 4 * channel up.
uint voxc_m2_2_2_m2_2_2_m2_2_2_channel_of(uint item, uint shift, uint least, uint head, uint channel) {
  uint bits = head >> (4u * channel) & 15u;
  return (item >> shift & ((1u << bits) - 1u)) + (least >> (8u * channel)) & 255u;
}

uint voxc_m2_2_2_m2_2_2_m2_2_2_value_of_item(uint item, uint least, uint head) {
  uint g_at = head & 15u;
  uint b_at = g_at + (head >> 4 & 15u);
  uint a_at = b_at + (head >> 8 & 15u);
  uint r = voxc_m2_2_2_m2_2_2_m2_2_2_channel_of(item, 0u, least, head, 0u);
  uint g = voxc_m2_2_2_m2_2_2_m2_2_2_channel_of(item, g_at, least, head, 1u);
  uint b = voxc_m2_2_2_m2_2_2_m2_2_2_channel_of(item, b_at, least, head, 2u);
  uint a = voxc_m2_2_2_m2_2_2_m2_2_2_channel_of(item, a_at, least, head, 3u);
  uint from = (head & voxc_m2_2_2_m2_2_2_m2_2_2_DIFFERENCES) != 0u ? g : 0u;
  return (r + from & 255u) | g << 8 | (b + from & 255u) << 16 | a << 24;
}

// The value of the voxel of a rank.
uint voxc_m2_2_2_m2_2_2_m2_2_2_value_of_rank(VOXC_VOLUME volume, uint rank) {
  uint section = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, 1u);
  uint block = section + voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume,
      section + (rank >> voxc_m2_2_2_m2_2_2_m2_2_2_LOG2_BLOCK));
  uint least = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, block);
  uint head = voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, block + 1u);
  uint i = rank & ((1u << voxc_m2_2_2_m2_2_2_m2_2_2_LOG2_BLOCK) - 1u);
  uint fields = block + voxc_m2_2_2_m2_2_2_m2_2_2_HEAD_WORDS;
  if ((head & voxc_m2_2_2_m2_2_2_m2_2_2_RUNS) != 0u) {
    i = voxc_m2_2_2_m2_2_2_m2_2_2_runs_until(volume, fields, i) - 1u;
    fields += voxc_m2_2_2_m2_2_2_m2_2_2_RUN_WORDS;
  }
  uint index_bits = head >> voxc_m2_2_2_m2_2_2_m2_2_2_INDEX_SHIFT & 15u;
  if (index_bits != 0u)
    i = voxc_m2_2_2_m2_2_2_m2_2_2_load_field(volume, fields, i, index_bits);
  uint bits = (head & 15u) + (head >> 4 & 15u) + (head >> 8 & 15u) + (head >> 12 & 15u);
  // Items without bits take no words, and a field is read with the word behind it: behind the last block is one word
  // alone.
  uint items = bits != 0u ? head >> voxc_m2_2_2_m2_2_2_m2_2_2_ITEMS_SHIFT : 0u;
  return voxc_m2_2_2_m2_2_2_m2_2_2_value_of_item(voxc_m2_2_2_m2_2_2_m2_2_2_load_field(volume, block + items, i, bits),
      least, head);
}

// What a voxel is: here its value is its colour.
uint voxc_m2_2_2_m2_2_2_m2_2_2_colour_of(VOXC_VOLUME volume, const voxc_m2_2_2_m2_2_2_m2_2_2_Traversal traversal) {
  return voxc_m2_2_2_m2_2_2_m2_2_2_value_of_rank(volume, voxc_m2_2_2_m2_2_2_m2_2_2_rank_level_1(volume,
      voxc_m2_2_2_m2_2_2_m2_2_2_load_word(volume, 0u), traversal.cell));
}

