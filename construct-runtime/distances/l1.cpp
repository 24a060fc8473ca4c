// Lowers `far` to one more than `near`, if it is more.
uint32_t lower_distance_level_${N}(uint32_t far, uint32_t near) { return near < far ? near + 1 : far; } // So adding 1 cannot wrap.

%if distances-beside
// A slot has a value, and then the distance of an empty cell.
constexpr uint64_t LEVEL_${N}_SLOT = ${slot-words};
uint32_t distance_level_${N}(const uint32_t *slot) { return slot[1]; }
void set_distance_level_${N}(uint32_t *slot, uint32_t distance) { slot[1] = distance; } // 0 of a cell that is not empty.
// One more than a distance, but for the greatest that a word can tell.
uint32_t after_distance_level_${N}(uint32_t distance) {
  return LEVEL_${N}_REACH == ~uint32_t{0} && distance == LEVEL_${N}_REACH ? distance : distance + 1;
}
%else
// An empty cell's word holds its distance; a word of 0 is a cell whose distance is not known yet.
constexpr uint64_t LEVEL_${N}_SLOT = ${slot-words};
constexpr uint32_t LEVEL_${N}_EMPTY = ${empty-tag}; // Which bits tell an empty cell.
uint32_t distance_level_${N}(const uint32_t *slot) {
  const uint32_t word = *slot;
  return ${word-is-empty} ? word & ~LEVEL_${N}_EMPTY : 0;
}
void set_distance_level_${N}(uint32_t *slot, uint32_t distance) {
  if (distance != 0)
    *slot = LEVEL_${N}_EMPTY | distance;
}
%end

// Lowers the distances of a run of slots to at most one more than those of their neighbours, which lie elsewhere.
void lower_level_${N}(uint32_t *__restrict slots, const uint32_t *__restrict neighbours, uint64_t count) {
%if distances-beside
  if (LEVEL_${N}_SLOT == 2) { // Every word, so that processors can take many at a time; but a value stays.
    for (uint64_t i = 0; i < 2 * count; ++i) {
      const uint32_t most = after_distance_level_${N}(neighbours[i]) | (i % 2 == 1 ? 0 : ~uint32_t{0});
      slots[i] = slots[i] < most ? slots[i] : most;
    }
    return;
  }
%end
  for (uint64_t i = 0; i < LEVEL_${N}_SLOT * count; i += LEVEL_${N}_SLOT)
    if (const uint32_t distance = distance_level_${N}(slots + i))
      set_distance_level_${N}(slots + i, lower_distance_level_${N}(distance, distance_level_${N}(neighbours + i)));
}

// The distances within a row of cells: a sweep forth and one back.
void measure_level_${N}_row(uint32_t *row) {
  constexpr uint64_t kRow = LEVEL_${N}_SLOT << LEVEL_${N}_SHAPE.x;
  uint32_t before = LEVEL_${N}_REACH;
  for (uint32_t *slot = row; slot < row + kRow; slot += LEVEL_${N}_SLOT) {
    before = *slot == 0 ? lower_distance_level_${N}(LEVEL_${N}_REACH, before) : 0;
    set_distance_level_${N}(slot, before);
  }
  uint32_t behind = before;
  for (uint32_t *slot = row + kRow - LEVEL_${N}_SLOT; slot > row;) {
    slot -= LEVEL_${N}_SLOT;
    behind = lower_distance_level_${N}(distance_level_${N}(slot), behind);
    set_distance_level_${N}(slot, behind);
  }
}

// The distances within one plane of cells; if it is too large for bytes, by a sweep forth and one back along x and along y.
void measure_level_${N}_plane(uint32_t *plane) {
  using Distances = PlaneDistances<LEVEL_${N}_SHAPE, LEVEL_${N}_REACH>;
  if constexpr (Distances::kFits)
    return Distances().measure(plane, LEVEL_${N}_SLOT, set_distance_level_${N});
  constexpr uint64_t kRow = LEVEL_${N}_SLOT << LEVEL_${N}_SHAPE.x;
  constexpr uint64_t kCells = uint64_t{1} << LEVEL_${N}_SHAPE.x;
  constexpr uint64_t kPlane = kRow << LEVEL_${N}_SHAPE.y;
  for (uint32_t *row = plane; row < plane + kPlane; row += kRow)
    measure_level_${N}_row(row);
  for (uint32_t *row = plane + kRow; row < plane + kPlane; row += kRow)
    lower_level_${N}(row, row - kRow, kCells);
  for (uint32_t *row = plane + kPlane - kRow; row > plane; row -= kRow)
    lower_level_${N}(row - kRow, row, kCells);
}

// L1 distances are separable: two sweeps an axis make them exact up to the reach. Plane after plane, there and back, so
// that a grid may be larger than memory.
void measure_level_${N}(Build &build, uint32_t *grid) {
  constexpr uint64_t kCells = uint64_t{1} << (LEVEL_${N}_SHAPE.x + LEVEL_${N}_SHAPE.y);
  constexpr uint64_t kPlane = LEVEL_${N}_SLOT * kCells;
  constexpr int kDepth = 1 << LEVEL_${N}_SHAPE.z;
  for (int z = 0; z < kDepth; ++z) {
    uint32_t *plane = grid + kPlane * static_cast<uint64_t>(z);
    measure_level_${N}_plane(plane);
    if (z > 0)
      lower_level_${N}(plane, plane - kPlane, kCells);
    build.pause(2 * kPlane);
  }
  for (int z = kDepth - 1; z > 0; --z) {
    uint32_t *plane = grid + kPlane * static_cast<uint64_t>(z);
    lower_level_${N}(plane - kPlane, plane, kCells);
    build.pause(2 * kPlane);
  }
}
