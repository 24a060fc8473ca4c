// A tree of depth 0 is one leaf.
bool is_voxel_level(uint leaf, ivec3 voxel) { return LEVEL_LAST || is_voxel_next(load_word(leaf), voxel); }
