// The value of a cell that is not empty. Adds to `rank` how many voxels of the grid come before those of the cell.
uint ranked_value_level(uint grid, ivec3 cell, inout uint rank) {
%if cone
  if (!is_there_level(grid, cell))
    return 0u;
%end
  uint slot = bits_before_level(grid, cell);
%if counts
  uint slots = load_word_at(grid, ${head-words}u - 1u) + uint(bitCount(load_word_at(grid, ${head-words}u - 2u)));
%else
  uint slots = uint(bitCount(load_word(grid)))${second-mask};
%end
  uint counts = slots * ${pointer-bits}u;
%if octant-counts
  rank += voxels_before_level(grid, cell, counts);
%else
  rank += load_field_at(grid + ${head-words}u, counts + slot * ${count-bits}u, ${count-bits}u);
%end
  return value_of_slot_level(grid, slot);
}

