// Shortens the slots of a packed grid of so many words: first the numbers of all sub-volumes, ${pointer-bits} bits each, then
%if octant-counts
// what stood behind the first of each octant of cells but the first, which has the least. Returns how many words that takes.
%else
// what stood behind them. Returns how many words that takes.
%end
uint64_t shorten_level_${N}(const uint32_t *grid, uint64_t words, uint32_t *shortened) {
  constexpr uint64_t kHead = ${head-words};
  const uint64_t slots = (words - kHead) / ${slot-words};
  const uint64_t numbers = slots * ${pointer-bits}; // Bits of them.
  for (uint64_t i = 0; i < kHead; ++i)
    shortened[i] = grid[i];
  for (uint64_t i = 0; i < slots; ++i) {
    const uint32_t *const slot = grid + kHead + ${slot-words-times}i;
    put_bits(shortened + kHead, i * ${pointer-bits}, ${pointer-bits}, slot[0]);
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
