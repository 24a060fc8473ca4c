%if implied
// Turns a grid of words, which follows ${head-words} words of room, into a mask of the cells that are not empty. Returns how
// many words that takes.
%if voxels-in-morton-order
// The values are put apart, in Morton order.
%else
%if ranked
// The values are put apart, in the order of the bits.
%end
%end
%else
// Turns a grid of slots, which follows ${head-words} words of room, into a mask and the slots of the cells that are not
// empty. Returns how many words that takes.
%end
uint64_t pack_level_${N}(Build &build, uint32_t *grid) {
  constexpr uint64_t kHead = ${head-words};
%if voxels-in-morton-order
  for (unsigned i = 0; i < LEVEL_${N}_SHAPE.cells(); ++i)
    if (const uint32_t value = grid[kHead + ${slot-words-times}LEVEL_${N}_SHAPE.index(brick_voxel(i))])
      build.put_value(value);
%end
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
%if voxels-in-morton-order
%else
%if ranked
      build.put_value(*slot);
%end
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

%if indexed
// Shortens the slots of a packed grid of so many words: first the numbers of all sub-volumes, ${index-bits} bits each, then
%if octant-counts
// what stood behind the first of each octant of cells but the first, which has the least. Returns how many words that takes.
%else
// what stood behind them. Returns how many words that takes.
%end
uint64_t shorten_level_${N}(const uint32_t *grid, uint64_t words, uint32_t *shortened) {
  constexpr uint64_t kHead = ${head-words};
  const uint64_t slots = (words - kHead) / ${slot-words};
  const uint64_t numbers = slots * ${index-bits}; // Bits of them.
  for (uint64_t i = 0; i < kHead; ++i)
    shortened[i] = grid[i];
  for (uint64_t i = 0; i < slots; ++i) {
    const uint32_t *const slot = grid + kHead + ${slot-words-times}i;
    put_bits(shortened + kHead, i * ${index-bits}, ${index-bits}, slot[0]);
%if ranked
%if octant-counts
%else
    put_bits(shortened + kHead, numbers + i * ${count-bits}, ${count-bits}, slot[1]);
%end
%end
  }
%if octant-counts
  // Bits and slots have one order, in which the first cell of an octant need not come first.
  constexpr uint32_t kNone = 0xffffffff;
  uint32_t least[8] = {kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone};
  const uint32_t *slot = grid + kHead;
  for (unsigned cell = 0; cell < 64; ++cell) {
    if ((grid[cell / 32] >> cell % 32 & 1) == 0)
      continue;
    uint32_t &before = least[(cell >> 1 & 1) | (cell >> 2 & 2) | (cell >> 3 & 4)];
    before = slot[1] < before ? slot[1] : before;
    slot += ${slot-words};
  }
  uint64_t end = numbers;
  for (const uint32_t before : least)
    if (before != kNone && before != 0) { // Before the first are none.
      put_bits(shortened + kHead, end, ${count-bits}, before);
      end += ${count-bits};
    }
  return kHead + (end + 31) / 32;
%else
  return kHead + (numbers + slots * ${count-bits} + 31) / 32;
%end
}

%end
uint32_t construct_level_${N}(Build &build, Voxel low) {
  constexpr uint64_t kRoom = ${head-words} + ${slot-words-times}LEVEL_${N}_SHAPE.cells();
  uint32_t *grid = nullptr;
%if slots-count
  uint32_t before = 0;
%end
  auto place = [&](const PlacedCell &placed) {
    if (!grid && !(grid = build.allocate(${N}, ${room})))
      return;
    uint32_t *const slot = grid + ${head-words} + ${slot-words-times}LEVEL_${N}_SHAPE.index(placed.cell);
    slot[0] = placed.value;
%if slots-count
    slot[1] = before;
    before += placed.voxels;
%end
  };
  for_each_cell<LEVEL_${N}_SHAPE, construct_${NEXT}>(build, low, {}, LEVEL_${N}_SHAPE.longest(), place);
  if (!grid)
    return 0;
%if indexed
  const uint64_t words = shorten_level_${N}(grid, pack_level_${N}(build, grid), grid + kRoom);
  const uint32_t offset = build.${write}(${N}, grid + kRoom, words);
%else
  const uint64_t words = pack_level_${N}(build, grid);
  const uint32_t offset = build.${write}(${N}, grid, words);
%end
  build.release(${N});
  return offset;
}
