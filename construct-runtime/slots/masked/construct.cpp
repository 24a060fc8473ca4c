uint32_t construct_level_${N}(Build &build, Voxel low) {
  uint32_t *grid = nullptr;
%if slots-count
  uint32_t before = 0;
%end
  auto place = [&](const PlacedCell &placed) {
    if (!grid && !(grid = build.allocate(${N}, kRoomForLevel${N})))
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
  const uint32_t offset = write_level_${N}(build, grid);
  build.release(${N});
  return offset;
}
