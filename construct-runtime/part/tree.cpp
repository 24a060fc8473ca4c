// Hands over the node over the aligned cube of 2^log2_side voxels a side at `low`, built apart.
void construct_level_${N}_part(Build &build, Voxel low, int log2_side) {
  build.finish(construct_level_${N}_node(build, low, (log2_side - LEVEL_${N}_LOG2_CELL) / LEVEL_${N}_BRANCH));
}
