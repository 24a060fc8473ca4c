%if implied
// A masked grid has a bit a cell, x fastest, then y, then z: all that are set have the same value.
%else
// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty.
%if indexed
// A value is the number of a sub-volume, in ${index-bits} bits.
%end
%if ranked
%if indexed
%if octant-counts
// In the bits behind them all, ${count-bits} each, stands how many voxels come before those of each octant of cells but the first.
%else
// In the bits behind them all, ${count-bits} each, stands how many voxels come before those of each cell.
%end
%else
// Each value is followed by how many voxels come before those of its cell.
%end
%end
%end
%if counts
// Each word of the mask is followed by how many bits the words before it have.
%end
%if ranks
%if voxels-in-morton-order
// How many voxels come before one, in Morton order: those of the octants of eight before its own, and those before it there.
uint voxels_before_level_${N}(uint grid, ivec3 cell) {
  ivec3 octant = cell >> 1 & 1;
  ivec3 place = cell & 1;
  uint octants = (1u << (octant.x | octant.y << 1)) - 1u; // A bit for each before it in its half,
  uint before = 0x00330033u * (octants & 1u | (octants & 2u) << 1 | (octants & 4u) << 6);
  uint cells = (1u << (place.x | place.y << 1 | place.z << 2)) - 1u; // and in its octant.
  cells = (cells | cells << 12) & 0x000f000fu;
  cells = (cells | cells << 2) & 0x00330033u;
  before |= cells << (2 * octant.x + 8 * octant.y);
  uint low = load_word(grid);
  uint half_mask = octant.z == 0 ? low : load_word(grid${+}1u);
  return uint(bitCount(half_mask & before)) + (octant.z == 0 ? 0u : uint(bitCount(low)));
}
%else
%if last
// How many voxels come before one.
uint voxels_before_level_${N}(uint grid, ivec3 cell) {
%else
// How many cells that are not empty come before one.
uint bits_before_level_${N}(uint grid, ivec3 cell) {
%end
  ivec3 at = cell & ((ivec3(1) << LEVEL_${N}_LOG2_SIZE) - 1);
  uint number = uint(at.x + ((at.y + (at.z << LEVEL_${N}_LOG2_SIZE.y)) << LEVEL_${N}_LOG2_SIZE.x));
  uint lower = (1u << (number & 31u)) - 1u;
%if counts
  uint mask_at = ${grid+}2u * (number >> 5);
  return load_word(${grid,}mask_at + 1u) + uint(bitCount(load_word(${grid,}mask_at) & lower));
%else
  uint before = number < 32u ? 0u : uint(bitCount(load_word(grid)));
  return before + uint(bitCount(load_word(grid${+}(number >> 5)) & lower));
%end
}
%end

%end
%if ranks
%if cone
// False of an empty cell, where a walk may stop that takes what is around for one.
bool is_there_level_${N}(uint grid, ivec3 cell) {
  ivec3 at = cell & ((ivec3(1) << LEVEL_${N}_LOG2_SIZE) - 1);
  uint number = uint(at.x + ((at.y + (at.z << LEVEL_${N}_LOG2_SIZE.y)) << LEVEL_${N}_LOG2_SIZE.x));
%if counts
  return (load_word(grid${+}2u * (number >> 5)) >> (number & 31u) & 1u) != 0u;
%else
  return (load_word(grid${+}(number >> 5)) >> (number & 31u) & 1u) != 0u;
%end
}

%end
%end
%if alike
%else
// The value of the cell that is not empty after so many others.
uint value_of_slot_level_${N}(uint grid, uint slot) {
%if indexed
%if grids-in-octants
  return load_field(grid + ${head-words}u, slot, ${index-bits}u);
%else
  return load_word(${array-head}u) + 2u * load_field(grid + ${head-words}u, slot, ${index-bits}u);
%end
%else
  return load_word(grid${+}${head-words}u + ${slots-times}slot);
%end
}

%end
%if slots-rank
%if octant-counts
// A bit for each octant of half a mask that is not empty: that of its first cell.
uint octants_of_half_level_${N}(uint half_mask) {
  uint bits = (half_mask | half_mask >> 16) & 0xffffu;
  return (bits | bits >> 1 | bits >> 4 | bits >> 5) & 0x0505u;
}

// How many voxels come before those of a cell, in Morton order: those before its octant of eight cells, which a count tells,
// and those of the cells before it there. The counts begin at a bit behind the mask.
uint voxels_before_level_${N}(uint grid, ivec3 cell, uint counts) {
  ivec3 octant = cell >> 1 & 1;
  ivec3 place = cell & 1;
  uint low = load_word(grid);
  uint half_mask = octant.z == 0 ? low : load_word(grid + 1u);
  uint lower = octant.z == 0 ? 0u : low; // The half that comes before all of it.
  int first = 2 * octant.x + 8 * octant.y;
  uint octants = octants_of_half_level_${N}(half_mask) & ((1u << first) - 1u) | octants_of_half_level_${N}(lower) << 16;
  uint earlier = uint(bitCount(octants));
  uint before = earlier == 0u ? 0u : load_field_at(grid + ${head-words}u, counts + (earlier - 1u) * ${count-bits}u, ${count-bits}u);
  uint cells = (1u << (place.x | place.y << 1 | place.z << 2)) - 1u;
  cells = (cells | cells << 12) & 0x000f000fu;
  cells = (cells | cells << 2) & 0x00330033u;
  cells = cells << first & half_mask;
  while (cells != 0u) {
    uint others = cells & (cells - 1u);
    uint until = (cells ^ others) - 1u; // The bits below the lowest of the cells.
    uint slot = uint(bitCount(lower) + bitCount(half_mask & until));
    uint other = value_of_slot_level_${N}(grid, slot);
%if grids-in-octants
    before += voxels_${NEXT}(other);
%else
    before += uint(bitCount(load_word(other)) + bitCount(load_word(other + 1u)));
%end
    cells = others;
  }
  return before;
}

%end
// The value of a cell that is not empty. Adds to `rank` how many voxels of the grid come before those of the cell.
uint ranked_value_level_${N}(uint grid, ivec3 cell, inout uint rank) {
%if cone
  if (!is_there_level_${N}(grid, cell))
    return 0u;
%end
  uint slot = bits_before_level_${N}(grid, cell);
%if indexed
%if counts
  uint slots = load_word(grid${+}${head-words}u - 1u) + uint(bitCount(load_word(grid${+}${head-words}u - 2u)));
%else
  uint slots = uint(bitCount(load_word(grid)))${second-mask};
%end
  uint counts = slots * ${index-bits}u;
%if octant-counts
  rank += voxels_before_level_${N}(grid, cell, counts);
%else
  rank += load_field_at(grid + ${head-words}u, counts + slot * ${count-bits}u, ${count-bits}u);
%end
%else
  rank += load_word(grid${+}${head-words}u + ${slots-times}slot + 1u);
%end
  return value_of_slot_level_${N}(grid, slot);
}

%end
%if tells-gap
// The number of a cell's bit, of which each word of the mask has 32.
int number_level_${N}(ivec3 cell) { return (cell.x & 3) | (cell.y & 3) << 2 | (cell.z & 3) << 4; }

%if alike
%else
// The value of a cell that is not empty.
uint value_level_${N}(uint grid, ivec3 cell) {
  int number = number_level_${N}(cell);
  uint low = load_word(grid);
  uint half_mask = number < 32 ? low : load_word(grid${+}1u);
  int rank = bitCount(half_mask & ((1u << (number & 31)) - 1u)) + (number < 32 ? 0 : bitCount(low));
  return value_of_slot_level_${N}(grid, uint(rank));
}

%end
%if last
// True if a voxel is there. Else the gap is as wide as the aligned group of eight cells around it, if they are all empty: half
// of the mask tells. To know more of four voxels a side takes longer than the steps that it would save.
bool is_full_level_${N}(const Ray ray, uint grid, ivec3 cell, inout Gap gap) {
  int number = number_level_${N}(cell);
  uint half_mask = load_word(grid${+}uint(number >> 5));
  gap.log2_side += (half_mask >> (number & 10) & 0x00330033u) == 0u ? 1 : 0;
  return (half_mask >> (number & 31) & 1u) != 0u;
}

%else
// True if a cell is full. Else the gap is as wide as the aligned group of eight cells around it, if they are all empty, or
// as the grid, if no cell is full that the ray may still come to.
bool is_full_level_${N}(const Ray ray, uint grid, ivec3 cell, inout Gap gap) {
  int number = number_level_${N}(cell);
  uint low = load_word(grid);
  uint high = load_word(grid${+}1u);
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
  gap.log2_side += around;
  return (half_mask >> (number & 31) & 1u) != 0u;
}

%end
// The same, and the value of a cell that is full; 0 of one that is not.
%if defers
%if colour
// A voxel's value is looked up once it is hit: here the grid stands for it.
%else
// What a voxel's value is nobody asks: the grid stands for it.
%end
%end
uint cell_level_${N}(${cell-ray-and}uint grid, ivec3 cell${cell-and-gap}) {
  return is_full_level_${N}(ray, grid, cell, gap) ? ${full-cell} : 0u;
}
%else
// The value of a cell, or 0 if it is empty.
uint cell_level_${N}(${cell-ray-and}uint grid, ivec3 cell${cell-and-gap}) {
%if first
  ivec3 at = cell;
%else
  ivec3 at = cell & ((ivec3(1) << LEVEL_${N}_LOG2_SIZE) - 1);
%end
  uint number = uint(at.x + ((at.y + (at.z << LEVEL_${N}_LOG2_SIZE.y)) << LEVEL_${N}_LOG2_SIZE.x));
  uint bit = 1u << (number & 31u);
%if alike
  return (load_word(grid${+}${mask-stride}(number >> 5)) & bit) != 0u ? ${occupied} : 0u;
%else
%if counts
  uint mask = load_word(grid${+}2u * (number >> 5));
  if ((mask & bit) == 0u)
    return 0u;
  uint rank = load_word(grid${+}2u * (number >> 5) + 1u) + uint(bitCount(mask & (bit - 1u)));
%else
  uint mask = load_word(grid${+}(number >> 5));
  if ((mask & bit) == 0u)
    return 0u;
  uint rank = uint(bitCount(mask & (bit - 1u)));
  if (number >= 32u)
    rank += uint(bitCount(load_word(grid)));
%end
  return value_of_slot_level_${N}(grid, rank);
%end
}
%end
%if sampled

// The first value of the grid.
%if implied
uint any_value_level_${N}(uint grid) { return ${occupied}; }
%else
uint any_value_level_${N}(uint grid) { return value_of_slot_level_${N}(grid, 0u); }
%end
%end
