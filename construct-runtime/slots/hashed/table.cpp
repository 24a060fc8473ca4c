// The longest that a probe may be, as in lib/Layout/HashedSlots.cpp.
constexpr uint32_t LEVEL_${N}_LONGEST_PROBE = 64;

// Puts cells, of a number and a value each, into a table of 2^log2_entries free entries. Returns the longest probe; more than
// is allowed if there is no place.
uint32_t fill_level_${N}(const uint32_t *cells, uint64_t count, uint32_t *entries, uint32_t log2_entries) {
  uint32_t longest = 0;
  for (uint64_t i = 0; i < count && longest <= LEVEL_${N}_LONGEST_PROBE; ++i) {
    const uint32_t home = cells[2 * i] * 0x9e3779b1u >> (32 - log2_entries);
    uint32_t probe = 0;
    uint32_t *entry = nullptr;
    do
      entry = entries + 2 * ((home + probe++) & ((uint64_t{1} << log2_entries) - 1));
    while (entry[1] != 0 && probe <= LEVEL_${N}_LONGEST_PROBE);
    longest = probe > longest ? probe : longest;
    if (entry[1] == 0) {
      entry[0] = cells[2 * i];
      entry[1] = cells[2 * i + 1];
    }
  }
  return longest;
}

// Half of the entries are free at least, and more where a probe would be too long.
uint32_t write_level_${N}(Build &build, const uint32_t *cells, uint64_t count) {
  uint32_t log2_entries = 1;
  while (uint64_t{1} << log2_entries < 2 * count)
    ++log2_entries;
  for (; log2_entries < 32; ++log2_entries) {
    const uint64_t words = 2 + (uint64_t{2} << log2_entries);
    uint32_t *table = build.allocate(${N}, words);
    if (!table)
      return 0;
    table[0] = log2_entries;
    table[1] = fill_level_${N}(cells, count, table + 2, log2_entries);
    uint32_t offset = 0;
    if (table[1] <= LEVEL_${N}_LONGEST_PROBE)
      offset = build.${write}(${N}, table, words);
    build.release(${N});
    if (offset != 0)
      return offset;
  }
  return 0;
}
