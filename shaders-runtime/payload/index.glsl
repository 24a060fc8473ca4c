// What a hit has in place of a colour: the number of its voxel among all of the volume, in Morton order.
uint colour_of(const Walk walk) { return rank_level_1(load_word(0u), walk.cell); }
