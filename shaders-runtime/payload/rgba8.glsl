// What a voxel is: here its value is its colour.
uint colour_of(uint voxel) { return voxel; }
