// Words for a grid that is being filled: those of its mask, and a slot for each cell; and for the same once more, shortened.
constexpr uint64_t kGridOfLevel${N} = ${head-words} + ${slot-words-times}LEVEL_${N}_SHAPE.cells();
constexpr uint64_t kRoomForLevel${N} = 2 * kGridOfLevel${N};

// Writes a filled grid with numbers in place of slots. Returns what leads to it.
uint32_t write_level_${N}(Build &build, uint32_t *grid) {
  uint32_t *const shortened = grid + kGridOfLevel${N};
  const uint64_t words = shorten_level_${N}(grid, pack_level_${N}(build, grid), shortened);
  return build.${write}(${N}, shortened, words);
}
