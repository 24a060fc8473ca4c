// Which child of a node a place lies in, counted in children.
int child_index(ivec3 place) {
  ivec3 bits = place & 1;
  return bits.x | bits.y << 1 | bits.z << 2;
}

// The same where a node has 4 x 4 x 4 children, in Morton order.
int child_index_of_64(ivec3 place) {
  ivec3 bits = (place & 1) | (place & 2) << 2;
  return bits.x | bits.y << 1 | bits.z << 2;
}
