// For each octant of directions, an empty cell has a field of ${field-bits} bits: the side of the largest empty cube that begins
// in the cell and goes that way. What lies outside of the grid is ${outside}.
constexpr uint32_t LEVEL_${N}_FIELD = ${field-mask};
constexpr uint32_t LEVEL_${N}_OUTSIDE = ${outside-side};

// The fields of a cell; 0 if it is not empty.
constexpr uint64_t LEVEL_${N}_SLOT = ${slot-words};
%if distances-beside
uint32_t *fields_level_${N}(uint32_t *slot) { return slot[0] == 0 ? slot + 1 : nullptr; }
%else
uint32_t *fields_level_${N}(uint32_t *slot) {
  const uint32_t word = *slot;
  return ${word-is-empty} ? slot : nullptr;
}
%end

// The field of an octant, which stands `shift` bits up, in a slot; null is outside.
uint32_t side_level_${N}(uint32_t *slot, unsigned shift) {
  if (!slot)
    return LEVEL_${N}_OUTSIDE;
  const uint32_t *const fields = fields_level_${N}(slot);
  return fields ? *fields >> shift & LEVEL_${N}_FIELD : 0;
}

// A cube of one cell in all directions, to begin with.
void clear_level_${N}_plane(uint32_t *plane) {
  constexpr uint64_t kCells = uint64_t{1} << (LEVEL_${N}_SHAPE.x + LEVEL_${N}_SHAPE.y);
  for (uint32_t *slot = plane; slot < plane + LEVEL_${N}_SLOT * kCells; slot += LEVEL_${N}_SLOT)
%if distances-beside
    slot[1] = slot[0] == 0 ? ${ones} : 0;
%else
    slot[0] = slot[0] == 0 ? ${ones} : slot[0];
%end
}

// The cubes of one octant from the cells of a row: one more than the least of the seven neighbours that lie ahead. `rows` are
// the row and its three neighbours ahead, null outside of the grid.
void measure_level_${N}_row(uint32_t *const (&rows)[4], unsigned octant) {
  constexpr int kWidth = 1 << LEVEL_${N}_SHAPE.x;
  const unsigned shift = octant * ${field-bits};
  uint32_t ahead = LEVEL_${N}_OUTSIDE; // The least of the four cells before this one.
  for (int i = 0; i < kWidth; ++i) {
    const uint64_t at = LEVEL_${N}_SLOT * static_cast<uint64_t>((octant & 1) != 0 ? kWidth - 1 - i : i);
    uint32_t aside = LEVEL_${N}_REACH;
    for (int row = 1; row < 4; ++row) {
      const uint32_t side = side_level_${N}(rows[row] ? rows[row] + at : nullptr, shift);
      aside = side < aside ? side : aside;
    }
    uint32_t side = 0;
    if (uint32_t *const fields = fields_level_${N}(rows[0] + at)) {
      side = 1 + (aside < ahead ? aside : ahead);
      side = side < LEVEL_${N}_REACH ? side : LEVEL_${N}_REACH;
      *fields = (*fields & ~(LEVEL_${N}_FIELD << shift)) | side << shift;
    }
    ahead = side < aside ? side : aside;
  }
}

// The four octants in which z rises, or falls, within a plane whose neighbour that way is `beyond`, null outside of the grid.
void measure_level_${N}_plane(uint32_t *plane, uint32_t *beyond, unsigned z_rises) {
  constexpr int kHeight = 1 << LEVEL_${N}_SHAPE.y;
  constexpr uint64_t kRow = LEVEL_${N}_SLOT << LEVEL_${N}_SHAPE.x;
  for (unsigned octant = 4 * z_rises; octant < 4 * z_rises + 4; ++octant)
    for (int i = 0; i < kHeight; ++i) {
      const bool y_rises = (octant & 2) != 0;
      const uint64_t at = kRow * static_cast<uint64_t>(y_rises ? kHeight - 1 - i : i);
      const uint64_t next = y_rises ? at + kRow : at - kRow;
      uint32_t *const rows[4] = {plane + at, i > 0 ? plane + next : nullptr, beyond ? beyond + at : nullptr,
                                 i > 0 && beyond ? beyond + next : nullptr};
      measure_level_${N}_row(rows, octant);
    }
}

// Plane after plane, there and back, so that a grid may be larger than memory.
void measure_level_${N}(Build &build, uint32_t *grid) {
  constexpr uint64_t kPlane = LEVEL_${N}_SLOT << (LEVEL_${N}_SHAPE.x + LEVEL_${N}_SHAPE.y);
  constexpr int kDepth = 1 << LEVEL_${N}_SHAPE.z;
  for (int z = 0; z < kDepth; ++z) {
    uint32_t *plane = grid + kPlane * static_cast<uint64_t>(z);
    clear_level_${N}_plane(plane);
    measure_level_${N}_plane(plane, z > 0 ? plane - kPlane : nullptr, 0);
    build.pause(2 * kPlane);
  }
  for (int z = kDepth - 1; z >= 0; --z) {
    uint32_t *plane = grid + kPlane * static_cast<uint64_t>(z);
    measure_level_${N}_plane(plane, z < kDepth - 1 ? plane + kPlane : nullptr, 1);
    build.pause(2 * kPlane);
  }
}
