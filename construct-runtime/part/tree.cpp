// Hands over the node over the aligned cube of 2^log2_side voxels a side at `low`, built apart.
void construct_level_N_part(Build &build, Voxel low, int log2_side) {
  build.finish(construct_level_N_node(build, low, log2_side - LEVEL_N_LOG2_CELL));
}
