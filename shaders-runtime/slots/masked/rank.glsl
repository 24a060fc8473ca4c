%if last
// How many voxels come before one.
uint voxels_before_level(uint grid, ivec3 cell) {
%else
// How many cells that are not empty come before one.
uint bits_before_level(uint grid, ivec3 cell) {
%end
  ivec3 at = cell & ((ivec3(1) << LEVEL_LOG2_SIZE) - 1);
  uint number = uint(at.x + ((at.y + (at.z << LEVEL_LOG2_SIZE.y)) << LEVEL_LOG2_SIZE.x));
  uint lower = (1u << (number & 31u)) - 1u;
%if counts
  uint mask_at = ${grid+}2u * (number >> 5);
  return load_word(${grid,}mask_at + 1u) + uint(bitCount(load_word(${grid,}mask_at) & lower));
%else
  uint before = number < 32u ? 0u : uint(bitCount(load_word(grid)));
  return before + uint(bitCount(load_word_at(grid, (number >> 5)) & lower));
%end
}

