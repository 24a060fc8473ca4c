uint32_t construct_level_${N}(Build &build, Voxel low) {
  auto place = [&](const PlacedCell &placed) {
    build.keep(${N}, static_cast<uint32_t>(LEVEL_${N}_SHAPE.index(placed.cell)), placed.value);
  };
  for_each_cell<LEVEL_${N}_SHAPE, construct_${NEXT}>(build, low, {}, LEVEL_${N}_SHAPE.longest(), place);
  uint64_t count = 0;
  const uint32_t *cells = build.kept(${N}, count);
  const uint32_t offset = count == 0 ? 0 : write_level_${N}(build, cells, count);
  build.drop(${N});
  return offset;
}
