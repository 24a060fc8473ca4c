// Words for a grid that is being filled: those of its mask, and a slot for each cell.
constexpr uint64_t kRoomForLevel${N} = ${head-words} + ${slot-words-times}LEVEL_${N}_SHAPE.cells();

// Writes a filled grid. Returns what leads to it.
uint32_t write_level_${N}(Build &build, uint32_t *grid) {
  const uint64_t words = pack_level_${N}(build, grid);
  return build.${write}(${N}, grid, words);
}
