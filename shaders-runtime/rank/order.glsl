// The rank of a voxel is how many voxels of the volume come before it. Each level counts those of one of its sub-volumes that
// do; of a place without a voxel, those before the least node around that has some.

// Every third bit of a word, the lowest first.
uint spread_bits(uint bits) {
  bits = (bits | bits << 16) & 0x030000ffu;
  bits = (bits | bits << 8) & 0x0300f00fu;
  bits = (bits | bits << 4) & 0x030c30c3u;
  return (bits | bits << 2) & 0x09249249u;
}

// The place of a cell, in Morton order, within the aligned cube of 2^log2_side cells a side around it, of 2^10 at most.
uint place_in_cube(ivec3 cell, int log2_side) {
  ivec3 at = cell & ((1 << log2_side) - 1);
  return spread_bits(uint(at.x)) | spread_bits(uint(at.y)) << 1 | spread_bits(uint(at.z)) << 2;
}
