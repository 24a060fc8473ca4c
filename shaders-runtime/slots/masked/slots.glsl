%if alike
%else
// The value of the cell that is not empty after so many others.
uint value_of_slot_level_${N}(uint grid, uint slot) { return load_word(grid${+}${head-words}u + ${slots-times}slot); }

%end
%if slots-rank
// The value of a cell that is not empty. Adds to `rank` how many voxels of the grid come before those of the cell.
uint ranked_value_level_${N}(uint grid, ivec3 cell, inout uint rank) {
%if cone
  if (!is_there_level_${N}(grid, cell))
    return 0u;
%end
  uint slot = bits_before_level_${N}(grid, cell);
  rank += load_word(grid${+}${head-words}u + ${slots-times}slot + 1u);
  return value_of_slot_level_${N}(grid, slot);
}

%end
