uint32_t construct_level_${N}(Build &build, Voxel low) {
%if distances-beside
  const uint64_t words = 2 * LEVEL_${N}_SHAPE.cells(); // Two a cell: terminating integer, distance.
%else
  const uint64_t words = LEVEL_${N}_SHAPE.cells();
%end
  uint32_t *grid = nullptr;
  auto place = [&](Voxel cell, uint32_t value) {
    if (grid || (grid = build.allocate(${N}, words)))
      grid[${slot-words-times}LEVEL_${N}_SHAPE.index(cell)] = ${slot-of-value};
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
