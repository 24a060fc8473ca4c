// A bit for each octant of half a mask that is not empty: that of its first cell.
uint octants_of_half_level(uint half_mask) {
  uint bits = (half_mask | half_mask >> 16) & 0xffffu;
  return (bits | bits >> 1 | bits >> 4 | bits >> 5) & 0x0505u;
}

// How many voxels come before those of a cell, in Morton order: those before its octant of eight cells, which a count tells,
// and those of the cells before it there. The counts begin at a bit behind the mask.
uint voxels_before_level(uint grid, ivec3 cell, uint counts) {
  ivec3 octant = cell >> 1 & 1;
  ivec3 place = cell & 1;
  uint low = load_word(grid);
  uint half_mask = octant.z == 0 ? low : load_word_at(grid, 1u);
  uint lower = octant.z == 0 ? 0u : low; // The half that comes before all of it.
  int first = 2 * octant.x + 8 * octant.y;
  uint octants = octants_of_half_level(half_mask) & ((1u << first) - 1u) | octants_of_half_level(lower) << 16;
  uint earlier = uint(bitCount(octants));
  uint before = 0u;
  if (earlier != 0u)
    before =
        load_field_at(grid, place_of_word(grid, LEVEL_HEAD_WORDS), counts + (earlier - 1u) * LEVEL_COUNT_BITS, LEVEL_COUNT_BITS);
  uint cells = (1u << (place.x | place.y << 1 | place.z << 2)) - 1u;
  cells = (cells | cells << 12) & 0x000f000fu;
  cells = (cells | cells << 2) & 0x00330033u;
  cells = cells << first & half_mask;
  while (cells != 0u) {
    uint others = cells & (cells - 1u);
    uint until = (cells ^ others) - 1u; // The bits below the lowest of the cells.
    uint slot = uint(bitCount(lower) + bitCount(half_mask & until));
    uint other = value_of_slot_level(grid, slot);
    if (LEVEL_LEADS_BY_NUMBER)
      before += voxels_next(other);
    else
      before += uint(bitCount(load_word(other)) + bitCount(load_word_at(other, 1u)));
    cells = others;
  }
  return before;
}
