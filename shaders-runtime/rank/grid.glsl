// How many voxels of the grid come before one.
uint rank_level_${N}(uint grid, ivec3 voxel) {
%if last
  return bits_before_level_${N}(grid, voxel);
%else
  uint slot = ranked_slot_level_${N}(grid, voxel >> LEVEL_${N}_LOG2_CELL);
  return load_word(slot + ${slot-words}u - 1u) + rank_${NEXT}(${value-at-slot}, voxel);
%end
}
