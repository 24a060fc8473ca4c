%if distances-beside
// A grid has two words a cell, x fastest, then y, then z: the value, and the distance of an empty cell.
%else
// A grid has a word a cell, x fastest, then y, then z.
%end
uint slot_level_${N}(uint grid, ivec3 cell) {
%if first
  ivec3 at = cell;
%else
  ivec3 at = cell & ((ivec3(1) << LEVEL_${N}_LOG2_SIZE) - 1);
%end
  return grid + ${slot-words}u * uint(at.x + ((at.y + (at.z << LEVEL_${N}_LOG2_SIZE.y)) << LEVEL_${N}_LOG2_SIZE.x));
}

%if octants
// The value of a cell, or 0 and, if it is empty, how many cells a side the empty cube ahead of it has for rays of an octant.
%if distances-in-slot
// A slot ${empty-slots} holds that, ${field-bits} bits for each octant.
%end
uint cell_level_${N}(uint grid, ivec3 cell, int octant, out uint reach) {
  uint slot = slot_level_${N}(grid, cell);
  uint value = load_word(slot);
%if distances-beside
  reach = value == 0u ? load_word(slot + 1u) >> (octant * ${field-bits}) & ${field-mask}u : 0u;
  return value;
%else
  bool is_empty = ${slot-is-empty};
  reach = value >> (octant * ${field-bits}) & ${field-mask}u;
  return is_empty ? 0u : ${value-of-slot};
%end
}
%else
%if distances
%if distances-in-slot
// The value of a cell, or 0 and its distance if it is empty: a slot ${empty-slots} holds that.
%else
// The value of a cell, or 0 and its distance if it is empty.
%end
uint cell_level_${N}(uint grid, ivec3 cell, out uint reach) {
  uint slot = slot_level_${N}(grid, cell);
  uint value = load_word(slot);
%if distances-beside
  reach = value == 0u ? load_word(slot + 1u) : 0u;
  return value;
%else
  bool is_empty = ${slot-is-empty};
  reach = value & 0x7fffffffu;
  return is_empty ? 0u : value;
%end
}
%else
// The value of a cell, or 0 if it is empty.
uint cell_level_${N}(uint grid, ivec3 cell) { return load_word(slot_level_${N}(grid, cell)); }
%end
%end
%if sampled

// The first value of the grid in an order that jumps about, so that a surface is met soon wherever it lies. 0 if the
// device cut the search short.
uint any_value_level_${N}(uint grid) {
  int count = 1 << (LEVEL_${N}_LOG2_SIZE.x + LEVEL_${N}_LOG2_SIZE.y + LEVEL_${N}_LOG2_SIZE.z);
  uint value = 0u;
%if distances
  uint reach;
%end
  for (int i = 0; i < count && value == 0u; i++) {
    // An odd factor visits every cell once; this one steps by 0.61 of 4096 cells.
    int at = i * 2481 & (count - 1);
    ivec3 cell = ivec3(at, at >> LEVEL_${N}_LOG2_SIZE.x, at >> (LEVEL_${N}_LOG2_SIZE.x + LEVEL_${N}_LOG2_SIZE.y));
    cell = cell & ((ivec3(1) << LEVEL_${N}_LOG2_SIZE) - 1);
%if distances
    value = cell_level_${N}(grid, cell${octant-0}, reach);
%else
    value = cell_level_${N}(grid, cell);
%end
  }
  return value;
}
%end
