// How many voxels come before one, in Morton order: those of the octants of eight before its own, and those before it there.
uint voxels_before_level(uint grid, ivec3 cell) {
  ivec3 octant = cell >> 1 & 1;
  ivec3 place = cell & 1;
  uint octants = (1u << (octant.x | octant.y << 1)) - 1u; // A bit for each before it in its half,
  uint before = 0x00330033u * (octants & 1u | (octants & 2u) << 1 | (octants & 4u) << 6);
  uint cells = (1u << (place.x | place.y << 1 | place.z << 2)) - 1u; // and in its octant.
  cells = (cells | cells << 12) & 0x000f000fu;
  cells = (cells | cells << 2) & 0x00330033u;
  before |= cells << (2 * octant.x + 8 * octant.y);
  uint low = load_word(grid);
  uint half_mask = octant.z == 0 ? low : load_word_at(grid, 1u);
  return uint(bitCount(half_mask & before)) + (octant.z == 0 ? 0u : uint(bitCount(low)));
}
