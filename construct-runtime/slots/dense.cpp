uint32_t construct_level_${N}(Build &build, Voxel low) {
  const uint64_t words = ${slot-words-times}LEVEL_${N}_SHAPE.cells(); // Of a cell: ${words-of-slot}.
  uint32_t *grid = nullptr;
%if ranked
  uint32_t before = 0;
%end
  auto place = [&](const PlacedCell &placed) {
    if (!grid && !(grid = build.allocate(${N}, words)))
      return;
    uint32_t *const slot = grid + ${slot-words-times}LEVEL_${N}_SHAPE.index(placed.cell);
    slot[0] = ${slot-of-value};
%if ranked
    slot[${slot-words} - 1] = before;
    before += placed.voxels;
%end
  };
  for_each_cell<LEVEL_${N}_SHAPE, construct_${NEXT}>(build, low, {}, LEVEL_${N}_SHAPE.longest(), place);
  if (!grid)
    return 0;
%if distances
  measure_level_${N}(build, grid);
%end
  const uint32_t offset = build.${write}(${N}, grid, words);
  build.release(${N});
  return offset;
}
