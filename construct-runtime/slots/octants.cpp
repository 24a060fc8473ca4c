// A grid is a bit a cell, in Morton order, until the array of all is written by octants.
%if ranked
// The values are put apart, in the same order.
%end
uint32_t construct_level_${N}(Build &build, Voxel low) {
  uint32_t *grid = nullptr;
  auto place = [&](const PlacedCell &placed) {
    if (!grid && !(grid = build.allocate(${N}, ${head-words})))
      return;
    const unsigned index = brick_index(placed.cell);
    grid[index / 32] |= 1u << index % 32;
%if ranked
    build.put_value(placed.value);
%end
  };
  for_each_cell<LEVEL_${N}_SHAPE, construct_${NEXT}>(build, low, {}, LEVEL_${N}_SHAPE.longest(), place);
  if (!grid)
    return 0;
  const uint32_t number = build.${write}(${N}, grid, ${head-words});
  build.release(${N});
  return number;
}
