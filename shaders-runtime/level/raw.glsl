// A raw grid stores its cells x fastest, then y, then z.
uint raw_cell(uint grid, ivec3 cell, ivec3 log2_size) {
  return load_word(grid + uint(cell.x + ((cell.y + (cell.z << log2_size.y)) << log2_size.x)));
}
