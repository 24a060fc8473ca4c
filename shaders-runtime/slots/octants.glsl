// Grids of 4 x 4 x 4 voxels stand in an array, and what leads to one is its number. A byte tells which of its octants of eight
// cells are not empty, and each of these has a byte of cells. Sixteen grids are a group, whose head has a word that tells at
// which byte of the array the cells of its first grid begin, and then the bytes of octants. All is in Morton order.

// Which octants of a grid are not empty, a bit for each, and the byte of the array at which their cells begin.
uint octants_level(uint grid, out uint cells) {
  uint number = grid - 1u;
  uint head = load_word(LEVEL_ARRAY_HEAD) + 5u * (number >> 4);
  uint place = number & 15u;
  cells = load_word(head);
  if (place > 3u)
    cells += uint(bitCount(load_word(head + 1u)));
  if (place > 7u)
    cells += uint(bitCount(load_word(head + 2u)));
  if (place > 11u)
    cells += uint(bitCount(load_word(head + 3u)));
  uint octants = load_word(head + 1u + (place >> 2));
  uint shift = 8u * (place & 3u);
  cells += uint(bitCount(octants & ((1u << shift) - 1u)));
  return octants >> shift & 255u;
}

// A byte of the array.
uint byte_level(uint at) { return load_word(load_word(LEVEL_ARRAY_HEAD) + (at >> 2)) >> 8u * (at & 3u) & 255u; }

// The number of a place in 2 x 2 x 2, and a bit for each before it.
int place_level(ivec3 place) { return place.x | place.y << 1 | place.z << 2; }
uint before_level(ivec3 place) { return (1u << place_level(place)) - 1u; }

// The cells of the octant around a cell, a bit for each: none if it is empty.
uint octant_level(uint octants, uint cells, ivec3 cell) {
  ivec3 octant = cell >> 1 & 1;
  if ((octants >> place_level(octant) & 1u) == 0u)
    return 0u;
  return byte_level(cells + uint(bitCount(octants & before_level(octant))));
}

// How many bits so many bytes of the array have, eight at most.
uint bits_of_bytes_level(uint first, uint bytes) {
  uint array = load_word(LEVEL_ARRAY_HEAD);
  uint few = min(bytes, 4u);
  uint bits = uint(bitCount(load_field_at(array, place_of_word(array, 0u), 8u * first, 8u * few)));
  return bytes > 4u ? bits + uint(bitCount(load_field_at(array, place_of_word(array, 0u), 8u * first + 32u, 8u * (bytes - few))))
                    : bits;
}

// How many voxels come before one.
uint voxels_before_level(uint grid, ivec3 cell) {
  uint cells;
  uint octants = octants_level(grid, cells);
  uint lower = octant_level(octants, cells, cell) & before_level(cell & 1);
  uint full = uint(bitCount(octants & before_level(cell >> 1 & 1)));
  return bits_of_bytes_level(cells, full) + uint(bitCount(lower));
}

// How many voxels a grid has.
uint voxels_level(uint grid) {
  uint cells;
  uint octants = octants_level(grid, cells);
  return bits_of_bytes_level(cells, uint(bitCount(octants)));
}

// False of an empty cell, where a traversal may stop that takes what is around for one.
bool is_there_level(uint grid, ivec3 cell) {
  uint cells;
  uint octants = octants_level(grid, cells);
  return (octant_level(octants, cells, cell) >> place_level(cell & 1) & 1u) != 0u;
}

// The value of a cell, or 0 if it is empty.
uint cell_level(uint grid, ivec3 cell) { return is_there_level(grid, cell) ? OCCUPIED : 0u; }

// A bit for each place in 2 x 2 x 2 to which a ray may still come from one of them.
uint ahead_level(const Ray ray, ivec3 place) {
  ivec3 from = place & ray.ahead;
  ivec3 to = place | (ray.ahead & 1);
  uvec3 sides = uvec3((ivec3(2) << to) - (ivec3(1) << from));
  return sides.x * (sides.y & 1u | (sides.y & 2u) << 1) * (sides.z & 1u | (sides.z & 2u) << 3);
}

// True if a cell is full. Else the empty span is as wide as the octant around it, if that is empty, or as the grid, if nothing is full
// to which the ray may still come: neither a cell of the octant nor any of the other octants.
bool is_full_level(const Ray ray, uint grid, ivec3 cell, inout EmptySpan span) {
  uint cells;
  uint octants = octants_level(grid, cells);
  ivec3 octant = cell >> 1 & 1;
  uint own = octant_level(octants, cells, cell);
  uint others = octants & ahead_level(ray, octant) & ~(1u << place_level(octant));
  int around = own == 0u ? 1 : 0;
  around = (others | (own & ahead_level(ray, cell & 1))) == 0u ? 2 : around;
  span.log2_side += around;
  return (own >> place_level(cell & 1) & 1u) != 0u;
}

// The same, and the value of a cell that is full; 0 of one that is not.
uint look_up_level(const Ray ray, uint grid, ivec3 cell, inout EmptySpan span) {
  if (LEVEL_DEFERS)
    return is_full_level(ray, grid, cell, span) ? grid : 0u; // Its value is looked up once it is hit.
  return is_full_level(ray, grid, cell, span) ? OCCUPIED : 0u;
}

// The first value of the grid.
uint any_value_level(uint grid) { return OCCUPIED; }
