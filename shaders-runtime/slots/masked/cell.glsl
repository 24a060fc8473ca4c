// The value of a cell, or 0 if it is empty.
uint cell_level(${cell-ray-and}uint grid, ivec3 cell${cell-and-gap}) {
%if first
  ivec3 at = cell;
%else
  ivec3 at = cell & ((ivec3(1) << LEVEL_LOG2_SIZE) - 1);
%end
  uint number = uint(at.x + ((at.y + (at.z << LEVEL_LOG2_SIZE.y)) << LEVEL_LOG2_SIZE.x));
  uint bit = 1u << (number & 31u);
%if alike
  return (load_word_at(grid, ${mask-stride}(number >> 5)) & bit) != 0u ? ${occupied} : 0u;
%else
%if counts
  uint mask = load_word_at(grid, 2u * (number >> 5));
  if ((mask & bit) == 0u)
    return 0u;
  uint rank = load_word_at(grid, 2u * (number >> 5) + 1u) + uint(bitCount(mask & (bit - 1u)));
%else
  uint mask = load_word_at(grid, (number >> 5));
  if ((mask & bit) == 0u)
    return 0u;
  uint rank = uint(bitCount(mask & (bit - 1u)));
  if (number >= 32u)
    rank += uint(bitCount(load_word(grid)));
%end
  return value_of_slot_level(grid, rank);
%end
}
%if sampled

// The first value of the grid.
%if implied
uint any_value_level(uint grid) { return ${occupied}; }
%else
uint any_value_level(uint grid) { return value_of_slot_level(grid, 0u); }
%end
%end
