%if distances-in-slot
// An empty cell's word holds its distance; a word of 0 is a cell whose distance is not known yet.
constexpr uint32_t LEVEL_${N}_EMPTY = ${empty-tag}; // Which bits tell an empty cell.
uint32_t distance_level_${N}(uint32_t word) { return ${word-is-empty} ? word & ~LEVEL_${N}_EMPTY : 0; }

// Lowers the distances of a run of cells to at most one more than those of their neighbours.
void lower_level_${N}(uint32_t *cells, const uint32_t *neighbours, uint64_t count) {
  for (uint64_t i = 0; i < count; ++i)
    if (distance_level_${N}(neighbours[i]) < distance_level_${N}(cells[i])) // So adding 1 cannot wrap.
      cells[i] = LEVEL_${N}_EMPTY | (distance_level_${N}(neighbours[i]) + 1);
}

// The distances within one plane of cells: a sweep forth and one back along x and along y.
void measure_level_${N}_plane(uint32_t *plane) {
  constexpr int kWidth = 1 << LEVEL_${N}_SHAPE.x;
  constexpr int kHeight = 1 << LEVEL_${N}_SHAPE.y;
  for (uint32_t *row = plane; row < plane + kWidth * kHeight; row += kWidth) {
    for (int x = 0; x < kWidth; ++x)
      row[x] = row[x] != 0 ? row[x] : LEVEL_${N}_EMPTY | LEVEL_${N}_REACH;
    for (int x = 1; x < kWidth; ++x)
      lower_level_${N}(row + x, row + x - 1, 1);
    for (int x = kWidth - 1; x > 0; --x)
      lower_level_${N}(row + x - 1, row + x, 1);
  }
  for (int y = 1; y < kHeight; ++y)
    lower_level_${N}(plane + kWidth * y, plane + kWidth * (y - 1), kWidth);
  for (int y = kHeight - 1; y > 0; --y)
    lower_level_${N}(plane + kWidth * (y - 1), plane + kWidth * y, kWidth);
}

// L1 distances are separable: two sweeps an axis make them exact up to the reach. Plane after plane, there and back, so
// that a grid may be larger than memory.
void measure_level_${N}(Build &build, uint32_t *grid) {
  constexpr uint64_t kPlane = uint64_t{1} << (LEVEL_${N}_SHAPE.x + LEVEL_${N}_SHAPE.y);
  constexpr int kDepth = 1 << LEVEL_${N}_SHAPE.z;
  for (int z = 0; z < kDepth; ++z) {
    uint32_t *plane = grid + kPlane * static_cast<uint64_t>(z);
    measure_level_${N}_plane(plane);
    if (z > 0)
      lower_level_${N}(plane, plane - kPlane, kPlane);
    build.pause(2 * kPlane);
  }
  for (int z = kDepth - 1; z > 0; --z) {
    uint32_t *plane = grid + kPlane * static_cast<uint64_t>(z);
    lower_level_${N}(plane - kPlane, plane, kPlane);
    build.pause(2 * kPlane);
  }
}
%else
// Lowers the distances of a run of cells to at most one more than those of their neighbours.
void lower_level_${N}(uint32_t *cells, const uint32_t *neighbours, uint64_t count) {
  for (uint64_t i = 1; i < 2 * count; i += 2)
    if (neighbours[i] < cells[i]) // So adding 1 cannot wrap.
      cells[i] = neighbours[i] + 1;
}

// The distances within one plane of cells: a sweep forth and one back along x and along y.
void measure_level_${N}_plane(uint32_t *plane) {
  constexpr int kWidth = 1 << LEVEL_${N}_SHAPE.x;
  constexpr int kHeight = 1 << LEVEL_${N}_SHAPE.y;
  for (uint32_t *row = plane; row < plane + 2 * kWidth * kHeight; row += 2 * kWidth) {
    for (int x = 0; x < kWidth; ++x)
      row[2 * x + 1] = row[2 * x] != 0 ? 0 : LEVEL_${N}_REACH;
    for (int x = 1; x < kWidth; ++x)
      lower_level_${N}(row + 2 * x, row + 2 * (x - 1), 1);
    for (int x = kWidth - 1; x > 0; --x)
      lower_level_${N}(row + 2 * (x - 1), row + 2 * x, 1);
  }
  for (int y = 1; y < kHeight; ++y)
    lower_level_${N}(plane + 2 * kWidth * y, plane + 2 * kWidth * (y - 1), kWidth);
  for (int y = kHeight - 1; y > 0; --y)
    lower_level_${N}(plane + 2 * kWidth * (y - 1), plane + 2 * kWidth * y, kWidth);
}

// L1 distances are separable: two sweeps an axis make them exact up to the reach. Plane after plane, there and
// back, so that a grid may be larger than memory.
void measure_level_${N}(Build &build, uint32_t *grid) {
  constexpr uint64_t kPlane = uint64_t{1} << (LEVEL_${N}_SHAPE.x + LEVEL_${N}_SHAPE.y);
  constexpr int kDepth = 1 << LEVEL_${N}_SHAPE.z;
  for (int z = 0; z < kDepth; ++z) {
    uint32_t *plane = grid + 2 * kPlane * static_cast<uint64_t>(z);
    measure_level_${N}_plane(plane);
    if (z > 0)
      lower_level_${N}(plane, plane - 2 * kPlane, kPlane);
    build.pause(4 * kPlane);
  }
  for (int z = kDepth - 1; z > 0; --z) {
    uint32_t *plane = grid + 2 * kPlane * static_cast<uint64_t>(z);
    lower_level_${N}(plane - 2 * kPlane, plane, kPlane);
    build.pause(4 * kPlane);
  }
}
%end
