// Hands over the cells of the aligned cube of 2^log2_side voxels a side at `low`, built apart.
void construct_level_${N}_part(Build &build, Voxel low, int log2_side) {
  finish_cells<LEVEL_${N}_SHAPE, construct_${NEXT}>(build, low, log2_side);
}
