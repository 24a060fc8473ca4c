// Turns a brick of words, which follows ${head-words} words of room, into a mask of the cells that are not empty. Returns how
// many words that takes.
%if ranked
// The values are put apart, in Morton order.
%end
uint64_t pack_level_${N}(Build &build, uint32_t *grid) {
  constexpr uint64_t kHead = ${head-words};
%if ranked
  for (unsigned i = 0; i < LEVEL_${N}_SHAPE.cells(); ++i)
    if (const uint32_t value = grid[kHead + ${slot-words-times}LEVEL_${N}_SHAPE.index(brick_voxel(i))])
      build.put_value(value);
%end
  for (uint64_t cell = 0; cell < LEVEL_${N}_SHAPE.cells(); ++cell)
    if (grid[kHead + ${slot-words-times}cell] != 0)
      grid[cell / 32] |= 1u << cell % 32;
  build.pause(32768);
  return kHead;
}
