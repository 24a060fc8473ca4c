// The number of a cell's bit, of which each word of the mask has 32.
int number_level(ivec3 cell) { return (cell.x & 3) | (cell.y & 3) << 2 | (cell.z & 3) << 4; }

// The value of a cell that is not empty.
uint value_level(uint grid, ivec3 cell) {
  int number = number_level(cell);
  uint low = load_word(grid);
  uint half_mask = number < 32 ? low : load_word_at(grid, 1u);
  int rank = bitCount(half_mask & ((1u << (number & 31)) - 1u)) + (number < 32 ? 0 : bitCount(low));
  return value_of_slot_level(grid, uint(rank));
}

// The value of a cell, or 0 if it is empty.
uint cell_level(uint grid, ivec3 cell) {
  int number = number_level(cell);
  bool is_full = (load_word_at(grid, uint(number >> 5)) >> (number & 31) & 1u) != 0u;
  if (LEVEL_ALIKE)
    return is_full ? OCCUPIED : 0u;
  return is_full ? value_level(grid, cell) : 0u;
}

// True if a cell is full. Else the empty span is as wide as the aligned group of eight cells around it, if they are all empty, or
// as the grid, if no cell is full that the ray may still come to.
bool is_full_level(const Ray ray, uint grid, ivec3 cell, inout EmptySpan span) {
  int number = number_level(cell);
  if (LEVEL_LAST) {
    // Half of the mask tells of the group. To know more of four voxels a side takes longer than the steps that it would save.
    uint half_mask = load_word_at(grid, uint(number >> 5));
    span.log2_side += (half_mask >> (number & 10) & 0x00330033u) == 0u ? 1 : 0;
    return (half_mask >> (number & 31) & 1u) != 0u;
  }
  uint low = load_word(grid);
  uint high = load_word_at(grid, 1u);
  uint half_mask = number < 32 ? low : high;
  int around = (half_mask >> (number & 10) & 0x00330033u) == 0u ? 1 : 0;
  // The rows, columns and planes from this cell on, a bit for each, and the 64 cells of which these are the sides.
  ivec3 at = cell & 3;
  ivec3 from = at & ray.ahead;
  ivec3 to = at | (ray.ahead & 3);
  uvec3 sides = uvec3((ivec3(2) << to) - (ivec3(1) << from));
  uint plane = sides.x * (sides.y & 1u | (sides.y & 2u) << 3 | (sides.y & 4u) << 6 | (sides.y & 8u) << 9);
  uint low_ahead = plane * (sides.z & 1u | (sides.z & 2u) << 15);
  uint high_ahead = plane * (sides.z >> 2 & 1u | (sides.z & 8u) << 13);
  around = ((low & low_ahead) | (high & high_ahead)) == 0u ? 2 : around;
  span.log2_side += around;
  return (half_mask >> (number & 31) & 1u) != 0u;
}

// The same, and the value of a cell that is full; 0 of one that is not.
uint look_up_level(const Ray ray, uint grid, ivec3 cell, inout EmptySpan span) {
  if (LEVEL_DEFERS)
    return is_full_level(ray, grid, cell, span) ? grid : 0u; // Its value is looked up once it is hit.
  if (LEVEL_IMPLIED)
    return is_full_level(ray, grid, cell, span) ? OCCUPIED : 0u;
  return is_full_level(ray, grid, cell, span) ? value_level(grid, cell) : 0u;
}

// The first value of the grid.
uint any_value_level(uint grid) { return LEVEL_IMPLIED ? OCCUPIED : value_of_slot_level(grid, 0u); }
