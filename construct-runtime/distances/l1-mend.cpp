// What an empty cell holds whose distance is not known: that the next one may be full.
void set_empty_level_${N}(uint32_t *slot) {
  slot[0] = 0;
  set_distance_level_${N}(slot, 1);
}

// Lowers the distances of a box of cells to at most one more than those of the cells before them along an axis, which are `step`
// slots away, or behind them; also by those just outside of the box, which are right.
void lower_level_${N}_box(uint32_t *grid, const CellBox &box, Voxel step, bool forth) {
  const auto lower = [&](Voxel cell) {
    const Voxel before = forth ? Voxel{cell.x - step.x, cell.y - step.y, cell.z - step.z}
                               : Voxel{cell.x + step.x, cell.y + step.y, cell.z + step.z};
    uint32_t *const slot = grid + LEVEL_${N}_SLOT * LEVEL_${N}_SHAPE.index(cell);
    const uint32_t distance = distance_level_${N}(slot);
    if (distance == 0 || (before.x | before.y | before.z) < 0 || LEVEL_${N}_SHAPE.excludes(before))
      return;
    const uint32_t *const neighbour = grid + LEVEL_${N}_SLOT * LEVEL_${N}_SHAPE.index(before);
    set_distance_level_${N}(slot, lower_distance_level_${N}(distance, distance_level_${N}(neighbour)));
  };
  for_each_in_order(box, {forth, forth, forth}, lower);
}

// Makes the distances right of all cells that those can change which became empty or full, and which `flipped` holds: a sweep
// forth and one back along each axis.
void mend_level_${N}(Edit &edit, uint32_t *grid, const CellBox &flipped) {
  constexpr int kReached = LEVEL_${N}_REACH < 1u << 21 ? static_cast<int>(LEVEL_${N}_REACH) - 1 : 1 << 21;
  const Voxel reached = {kReached, kReached, kReached};
  const CellBox box = flipped.grown<LEVEL_${N}_SHAPE>(reached, reached);
  touch_rows<LEVEL_${N}_SHAPE>(edit, ${N}, grid, LEVEL_${N}_SLOT, box);
  for_each_in_order(box, {true, true, true}, [&](Voxel cell) {
    uint32_t *const slot = grid + LEVEL_${N}_SLOT * LEVEL_${N}_SHAPE.index(cell);
    if (value_level_${N}(slot) == 0)
      set_distance_level_${N}(slot, LEVEL_${N}_REACH);
  });
  constexpr Voxel kSteps[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Voxel step : kSteps) {
    lower_level_${N}_box(grid, box, step, true);
    lower_level_${N}_box(grid, box, step, false);
  }
}
