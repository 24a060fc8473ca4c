// What an empty cell holds of which no more is known.
void set_empty_level_${N}(uint32_t *slot) {
%if distances-beside
  slot[0] = 0;
  slot[1] = ${ones};
%else
  slot[0] = ${ones};
%end
}

// The cubes of one octant from the cells of a box, those that lie farthest ahead first: one more than the least of the seven
// neighbours ahead, of which those outside of the box are right.
void mend_level_${N}_octant(uint32_t *grid, const CellBox &box, unsigned octant) {
  const unsigned shift = octant * ${field-bits};
  const Voxel ahead = {(octant & 1) != 0 ? 1 : -1, (octant & 2) != 0 ? 1 : -1, (octant & 4) != 0 ? 1 : -1};
  for_each_in_order(box, {ahead.x < 0, ahead.y < 0, ahead.z < 0}, [&](Voxel cell) {
    uint32_t *const fields = fields_level_${N}(grid + LEVEL_${N}_SLOT * LEVEL_${N}_SHAPE.index(cell));
    if (!fields)
      return;
    uint32_t least = LEVEL_${N}_REACH - 1;
    for (int i = 1; i < 8 && least > 0; ++i) {
      const Voxel at = {cell.x + (i & 1) * ahead.x, cell.y + (i >> 1 & 1) * ahead.y, cell.z + (i >> 2) * ahead.z};
      const bool is_outside = (at.x | at.y | at.z) < 0 || LEVEL_${N}_SHAPE.excludes(at);
      uint32_t *const slot = is_outside ? nullptr : grid + LEVEL_${N}_SLOT * LEVEL_${N}_SHAPE.index(at);
      const uint32_t side = side_level_${N}(slot, shift);
      least = side < least ? side : least;
    }
    *fields = (*fields & ~(LEVEL_${N}_FIELD << shift)) | (least + 1) << shift;
  });
}

// Makes the cubes right of all cells that those can change which became empty or full, and which `flipped` holds: of each octant
// the cells that lie behind them.
void mend_level_${N}(Edit &edit, uint32_t *grid, const CellBox &flipped) {
  constexpr int kReached = static_cast<int>(LEVEL_${N}_REACH) - 1;
  const Voxel all = {kReached, kReached, kReached};
  touch_rows<LEVEL_${N}_SHAPE>(edit, ${N}, grid, LEVEL_${N}_SLOT, flipped.grown<LEVEL_${N}_SHAPE>(all, all));
  for (unsigned octant = 0; octant < 8; ++octant) {
    const auto reached = [&](bool rises) { return rises ? kReached : 0; };
    const Voxel before = {reached((octant & 1) != 0), reached((octant & 2) != 0), reached((octant & 4) != 0)};
    const Voxel behind = {kReached - before.x, kReached - before.y, kReached - before.z};
    mend_level_${N}_octant(grid, flipped.grown<LEVEL_${N}_SHAPE>(before, behind), octant);
  }
}
