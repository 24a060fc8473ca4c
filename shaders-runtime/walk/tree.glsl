// Which child of a node the cell lies in; the child covers 2^height cells a side.
int child_index(ivec3 cell, int height) {
  ivec3 bits = (cell >> height) & 1;
  return bits.x | bits.y << 1 | bits.z << 2;
}
