// A tree of depth 0 is one leaf.
%if last
bool is_voxel_level(uint leaf, ivec3 voxel) { return true; }
%else
bool is_voxel_level(uint leaf, ivec3 voxel) { return is_voxel_next(load_word(leaf), voxel); }
%end
