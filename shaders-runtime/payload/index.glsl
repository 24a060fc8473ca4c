// What a hit has in place of a colour: how many voxels of the volume come before its own.
uint colour_of(const Traversal traversal) { return rank_level_1(load_word(0u), traversal.cell); }
