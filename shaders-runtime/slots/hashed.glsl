// A hashed grid is [log2 of its entries, longest probe], then two words an entry: a cell's number, its value. Entries of
// value 0 are free.
// The value of a cell, or 0 if it is empty. The gap has no cells if the device cut the search short.
uint cell_level(${cell-ray-and}uint table, ivec3 cell${cell-and-gap}) {
  ivec3 at = cell & ((ivec3(1) << LEVEL_LOG2_SIZE) - 1);
  uint number = uint(at.x + ((at.y + (at.z << LEVEL_LOG2_SIZE.y)) << LEVEL_LOG2_SIZE.x));
  uint log2_entries = load_word(table);
  uint probes = load_word_at(table, 1u);
  uint home = number * 0x9e3779b1u >> (32u - log2_entries);
  uint found = 0u;
  uint probe = 0u;
  while (probe < probes) {
    uint entry = ${table+}2u + 2u * (home + probe & ((1u << log2_entries) - 1u));
    uint value = load_word(${table,}entry + 1u);
    bool is_cell = load_word(${table,}entry) == number;
    found = is_cell ? value : found;
    probe = is_cell || value == 0u ? probes : probe + 1u;
  }
  if (LEVEL_LOOK_UP_MAY_BE_CUT)
    gap.count = probe == probes ? 1 : 0;
  return found;
}

// The first value of the table. 0 if the device cut the search short.
uint any_value_level(uint table) {
  uint entries = 1u << load_word(table);
  uint value = 0u;
  for (uint i = 0u; i < entries && value == 0u; i++)
    value = load_word_at(table, 3u + 2u * i);
  return value;
}
