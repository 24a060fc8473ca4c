// What a voxel is: here nothing but that it is there, which is shown in white.
uint colour_of(const Traversal traversal) { return OCCUPIED; }
