// A tree of depth 0 is one leaf, whose voxels are those of its cell.
uint rank_level(uint leaf, ivec3 voxel) { return rank_next(load_word(leaf), voxel); }
