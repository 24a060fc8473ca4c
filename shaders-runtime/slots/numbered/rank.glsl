// The value of a cell that is not empty. Adds to `rank` how many voxels of the grid come before those of the cell: in the bits
// behind all numbers that is told of each cell, or of each octant of cells but the first.
uint ranked_value_level(uint grid, ivec3 cell, inout uint rank) {
  if (CONE && !is_there_level(grid, cell))
    return 0u;
  uint slot = bits_before_level(grid, cell);
  uint slots;
  if (LEVEL_COUNTS)
    slots = load_word_at(grid, LEVEL_HEAD_WORDS - 1u) + uint(bitCount(load_word_at(grid, LEVEL_HEAD_WORDS - 2u)));
  else
    slots = uint(bitCount(load_word(grid))) + (LEVEL_HAS_TWO_MASK_WORDS ? uint(bitCount(load_word_at(grid, 1u))) : 0u);
  uint counts = slots * LEVEL_POINTER_BITS;
  if (LEVEL_OCTANT_COUNTS)
    rank += voxels_before_level(grid, cell, counts);
  else
    rank += load_field_at(grid, place_of_word(grid, LEVEL_HEAD_WORDS), counts + slot * LEVEL_COUNT_BITS, LEVEL_COUNT_BITS);
  return value_of_slot_level(grid, slot);
}
