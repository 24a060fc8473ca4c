// What a voxel is: here an opaque colour, of which its value has 5, 6 and 5 bits, a byte each.
uint colour_of(const Traversal traversal) {
  uint value = value_of_rank(rank_level_1(load_word(0u), traversal.cell));
  uint high = value << 3 & 0x00f800f8u | (value & 0x00003f00u) << 2;
  uint low = value >> 2 & 0x00070007u | value >> 4 & 0x00000300u;
  return high | low | 0xff000000u;
}
