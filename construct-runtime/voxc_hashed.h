// voxc_hashed.h: tables of the cells that are not empty, found by probing.
#pragma once

#include "voxc_grid.h"

namespace voxc::construct {

/// The longest that a probe may be, as in lib/Layout/HashedSlots.cpp.
constexpr uint32_t kLongestProbe = 64;

template <typename Level> struct HashedTable {
  /// Writes cells, of a number and a value each. Half of the entries are free at least, and more where a
  /// probe would be too long. Returns what leads to the table; 0 if building has failed.
  static uint32_t write(Build &build, const uint32_t *cells, uint64_t count) {
    uint32_t log2_entries = 1;
    while (uint64_t{1} << log2_entries < 2 * count)
      ++log2_entries;
    for (; log2_entries < 32; ++log2_entries) {
      const uint64_t words = 2 + (uint64_t{2} << log2_entries);
      uint32_t *table = build.allocate(Level::NUMBER, words);
      if (!table)
        return 0;
      table[0] = log2_entries;
      table[1] = fill(cells, count, table + 2, log2_entries);
      uint32_t offset = 0;
      if (table[1] <= kLongestProbe)
        offset = put_words<Level>(build, table, words);
      build.release(Level::NUMBER);
      if (offset != 0)
        return offset;
    }
    return 0;
  }

private:
  /// Puts cells into a table of 2^log2_entries free entries. Returns the longest probe; more than is allowed
  /// if there is no place.
  static uint32_t fill(const uint32_t *cells, uint64_t count, uint32_t *entries, uint32_t log2_entries) {
    uint32_t longest = 0;
    for (uint64_t i = 0; i < count && longest <= kLongestProbe; ++i) {
      const uint32_t home = cells[2 * i] * 0x9e3779b1u >> (32 - log2_entries);
      uint32_t probe = 0;
      uint32_t *entry = nullptr;
      do
        entry = entries + 2 * ((home + probe++) & ((uint64_t{1} << log2_entries) - 1));
      while (entry[1] != 0 && probe <= kLongestProbe);
      longest = probe > longest ? probe : longest;
      if (entry[1] == 0) {
        entry[0] = cells[2 * i];
        entry[1] = cells[2 * i + 1];
      }
    }
    return longest;
  }
};

template <typename Level> struct HashedGrid : GridPart<Level> {
  /// Builds the sub-volume at `low`; returns what leads to it, 0 if it has no voxel.
  static uint32_t construct(Build &build, Voxel low) {
    auto place = [&](const PlacedCell &placed) {
      build.keep(Level::NUMBER, static_cast<uint32_t>(Level::SHAPE.index(placed.cell)), placed.value);
    };
    for_each_cell<Level>(build, low, {}, Level::SHAPE.longest(), place);
    uint64_t count = 0;
    const uint32_t *cells = build.kept(Level::NUMBER, count);
    const uint32_t offset = count == 0 ? 0 : HashedTable<Level>::write(build, cells, count);
    build.drop(Level::NUMBER);
    return offset;
  }
};

} // namespace voxc::construct
