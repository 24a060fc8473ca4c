// A hashed grid is [log2 of its entries, longest probe], then two words an entry: a cell's number, its value. Entries of
// value 0 are free.
// The value of a cell, or 0 if it is empty. The device may cut the search short.
uint probe_level(uint table, ivec3 cell, out bool is_cut) {
  ivec3 at = cell & ((ivec3(1) << LEVEL_LOG2_SIZE) - 1);
  uint number = uint(at.x + ((at.y + (at.z << LEVEL_LOG2_SIZE.y)) << LEVEL_LOG2_SIZE.x));
  uint log2_entries = load_word(table);
  uint probes = load_word_at(table, 1u);
  uint home = number * 0x9e3779b1u >> (32u - log2_entries);
  uint found = 0u;
  uint probe = 0u;
  while (probe < probes) {
    uint entry = place_of_word(table, 2u + 2u * (home + probe & ((1u << log2_entries) - 1u)));
    uint value = load_word_from(table, entry + 1u);
    bool is_cell = load_word_from(table, entry) == number;
    found = is_cell ? value : found;
    probe = is_cell || value == 0u ? probes : probe + 1u;
  }
  is_cut = probe != probes;
  return found;
}

uint cell_level(uint table, ivec3 cell) {
  bool is_cut;
  return probe_level(table, cell, is_cut);
}

// The same. The span has no cells if the device cut the search short.
uint look_up_level(const Ray ray, uint table, ivec3 cell, inout EmptySpan span) {
  bool is_cut;
  uint value = probe_level(table, cell, is_cut);
  if (LEVEL_LOOK_UP_MAY_BE_CUT)
    span.count = is_cut ? 0 : 1;
  return value;
}

// The first value of the table. 0 if the device cut the search short.
uint any_value_level(uint table) {
  uint entries = 1u << load_word(table);
  uint value = 0u;
  for (uint i = 0u; i < entries && value == 0u; i++)
    value = load_word_at(table, 3u + 2u * i);
  return value;
}
