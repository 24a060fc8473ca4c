// A grid has a slot a cell, x fastest, then y, then z: ${words-of-slot}.
%if granules
// Moves on to the granule of a cell's slot, and gives its word there.
uint slot_level(inout uint grid, ivec3 cell) {
%else
uint slot_level(uint grid, ivec3 cell) {
%end
%if first
  ivec3 at = cell;
%else
  ivec3 at = cell & ((ivec3(1) << LEVEL_LOG2_SIZE) - 1);
%end
%if granules
  grid += ${slots-times}uint(${granule-of-cell});
  return ${slots-times}uint(${cell-in-granule});
%else
  return grid + ${slots-times}uint(at.x + ((at.y + (at.z << LEVEL_LOG2_SIZE.y)) << LEVEL_LOG2_SIZE.x));
%end
}

%if distances-in-slot
// The value in a slot, or 0 if its cell is empty: a slot ${empty-slots} holds ${skip-of-slot} instead.
uint value_level(uint word) { return ${slot-is-empty} ? 0u : ${value-of-slot}; }

%end
%if point
// The value of a cell, or 0 if it is empty.
uint cell_level(uint grid, ivec3 cell) {
  uint slot = slot_level(grid, cell);
  return ${value-at-slot};
}
%else
%if distances
// The value of a cell, or 0 if it is empty; `gap` then counts ${what-skip-counts}.
uint cell_level(${cell-ray-and}uint grid, ivec3 cell${cell-and-gap}) {
  uint slot = slot_level(grid, cell);
  uint word = load_word(${grid,}slot);
%if distances-beside
  uint skip = word == 0u ? load_word(${grid,}slot + 1u) : 0u;
  gap.count = int(${skip-in-word});
  return word;
%else
  uint skip = word;
  gap.count = int(${skip-in-word});
  return value_level(word);
%end
}
%else
// The value of a cell, or 0 if it is empty.
%if granules
uint cell_level(${cell-ray-and}uint grid, ivec3 cell${cell-and-gap}) {
  uint slot = slot_level(grid, cell);
  return load_word(grid, slot);
}
%else
uint cell_level(${cell-ray-and}uint grid, ivec3 cell${cell-and-gap}) { return load_word(slot_level(grid, cell)); }
%end
%end
%end

// The value of a cell that is not empty. Adds to `rank` how many voxels of the grid come before those of the cell.
uint ranked_value_level(uint grid, ivec3 cell, inout uint rank) {
  uint slot = slot_level(grid, cell);
  rank += load_word(${grid,}slot + ${slot-words}u - 1u);
  return ${value-at-slot};
}

// The first value of the grid in an order that jumps about, so that a surface is met soon wherever it lies. 0 if the
// device cut the search short.
uint any_value_level(uint grid) {
  int count = 1 << (LEVEL_LOG2_SIZE.x + LEVEL_LOG2_SIZE.y + LEVEL_LOG2_SIZE.z);
  uint value = 0u;
  for (int i = 0; i < count && value == 0u; i++) {
    // An odd factor visits every cell once; this one steps by 0.61 of 4096 cells.
    int at = i * 2481 & (count - 1);
    ivec3 cell = ivec3(at, at >> LEVEL_LOG2_SIZE.x, at >> (LEVEL_LOG2_SIZE.x + LEVEL_LOG2_SIZE.y));
    cell = cell & ((ivec3(1) << LEVEL_LOG2_SIZE) - 1);
%if granules
    uint node = grid;
    uint slot = slot_level(node, cell);
    value = load_word(node, slot);
%else
    value = load_word(slot_level(grid, cell));
%end
%if distances-in-slot
    value = value_level(value);
%end
  }
  return value;
}
