// A tree of depth 0 is one leaf, whose voxels are those of its cell.
uint rank_level_${N}(uint leaf, ivec3 voxel) { return rank_${NEXT}(load_word(leaf), voxel); }
