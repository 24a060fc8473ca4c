// What a voxel is: here its value is its colour.
%if values-apart
uint colour_of(const Walk walk) { return value_of_rank(rank_level_1(load_word(0u), walk.cell)); }
%else
%if value-later
uint colour_of(const Walk walk) { return value_level_${LOWEST_LEVEL}(walk.voxel, walk.cell); }
%else
%if defers-leaf
uint colour_of(const Walk walk) { return load_word(walk.voxel); }
%else
uint colour_of(const Walk walk) { return walk.voxel; }
%end
%end
%end
