%if implied
// Turns a grid of words, which follows ${head-words} words of room, into a mask of the cells that are not empty. Returns how
// many words that takes.
%if ranked
// The values are put apart, in the order of the bits.
%end
%else
// Turns a grid of slots, which follows ${head-words} words of room, into a mask and the slots of the cells that are not
// empty. Returns how many words that takes.
%end
uint64_t pack_level_${N}(Build &build, uint32_t *grid) {
  constexpr uint64_t kHead = ${head-words};
  uint64_t end = kHead;
%if counts
  uint32_t count = 0;
%end
  for (uint64_t first = 0; first < LEVEL_${N}_SHAPE.cells(); first += 32) {
%if counts
    uint32_t *mask = grid + first / 32 * 2;
    mask[1] = count;
%else
    uint32_t *mask = grid + first / 32;
%end
    for (uint64_t cell = first; cell < LEVEL_${N}_SHAPE.cells() && cell < first + 32; ++cell) {
      const uint32_t *const slot = grid + kHead + ${slot-words-times}cell;
      if (*slot == 0)
        continue;
      *mask |= 1u << (cell - first);
%if counts
      ++count;
%end
%if implied
%if ranked
      build.put_value(*slot);
%end
%else
      grid[end++] = slot[0];
%if slots-count
      grid[end++] = slot[1];
%end
%end
    }
    if (first % 32768 == 0)
      build.pause(32768);
  }
  return end;
}
