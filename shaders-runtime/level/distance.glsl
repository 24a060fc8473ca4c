// A distance field stores two words a cell, x fastest, then y, then z: terminating integer, distance.
uint distance_entry(uint grid, ivec3 cell, ivec3 log2_size) {
  return grid + 2u * uint(cell.x + ((cell.y + (cell.z << log2_size.y)) << log2_size.x));
}
