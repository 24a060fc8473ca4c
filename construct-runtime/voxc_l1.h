// voxc_l1.h: for each empty cell of a grid how far the nearest full one is, in steps along the axes.
#pragma once

#include "voxc_dense.h"
#include "voxc_plane.h"

namespace voxc::construct {

/// Where the distance of a cell stands: beside its value, 0 of a cell that is not empty; or in the word of an
/// empty cell, where a word of 0 is a cell whose distance is not known yet.
template <typename Level> struct L1Slot {
  static constexpr uint64_t kWords = Level::SLOT_WORDS;
  static constexpr uint32_t kEmpty =
      Level::EMPTY_BY_ALPHA ? 0 : 0x80000000u; ///< Which bits say that a cell is empty.

  static uint32_t distance(const uint32_t *slot) {
    if constexpr (Level::DISTANCES_BESIDE)
      return slot[1];
    else
      return SlotWord<Level>::is_empty(*slot) ? *slot & ~kEmpty : 0;
  }
  static void set_distance(uint32_t *slot, uint32_t distance) {
    if constexpr (Level::DISTANCES_BESIDE)
      slot[1] = distance;
    else if (distance != 0)
      *slot = kEmpty | distance;
  }
  /// Lowers `far` to one more than `near`, if it is more.
  static uint32_t lowered(uint32_t far, uint32_t near) {
    return near < far ? near + 1 : far;
  } // Adding 1 cannot wrap.
};

/// L1 distances are separable: two sweeps an axis make them exact up to the reach. Plane after plane, there
/// and back, so that a grid may be larger than memory.
template <typename Level> struct L1Field {
  static void measure(Build &build, uint32_t *grid) {
    constexpr uint64_t kCells = uint64_t{1} << (Level::SHAPE.x + Level::SHAPE.y);
    constexpr uint64_t kPlane = Slot::kWords * kCells;
    constexpr int kDepth = 1 << Level::SHAPE.z;
    for (int z = 0; z < kDepth; ++z) {
      uint32_t *plane = grid + kPlane * static_cast<uint64_t>(z);
      measure_plane(plane);
      if (z > 0)
        lower(plane, plane - kPlane, kCells);
      build.pause(2 * kPlane);
    }
    for (int z = kDepth - 1; z > 0; --z) {
      uint32_t *plane = grid + kPlane * static_cast<uint64_t>(z);
      lower(plane - kPlane, plane, kCells);
      build.pause(2 * kPlane);
    }
  }

private:
  using Slot = L1Slot<Level>;

  /// One more than a distance, but for the greatest that a word can hold.
  static uint32_t after(uint32_t distance) {
    return Level::REACH == ~uint32_t{0} && distance == Level::REACH ? distance : distance + 1;
  }

  /// Lowers the distances of a run of slots to at most one more than those of their neighbours, which lie
  /// elsewhere.
  static void lower(uint32_t *__restrict slots, const uint32_t *__restrict neighbours, uint64_t count) {
    if constexpr (Level::DISTANCES_BESIDE && Slot::kWords == 2) {
      // Every word, so that processors can take many at a time; but a value stays.
      for (uint64_t i = 0; i < 2 * count; ++i) {
        const uint32_t most = after(neighbours[i]) | (i % 2 == 1 ? 0 : ~uint32_t{0});
        slots[i] = slots[i] < most ? slots[i] : most;
      }
    } else {
      for (uint64_t i = 0; i < Slot::kWords * count; i += Slot::kWords)
        if (const uint32_t distance = Slot::distance(slots + i))
          Slot::set_distance(slots + i, Slot::lowered(distance, Slot::distance(neighbours + i)));
    }
  }

  /// The distances within a row of cells: a sweep forth and one back.
  static void measure_row(uint32_t *row) {
    constexpr uint64_t kRow = Slot::kWords << Level::SHAPE.x;
    uint32_t before = Level::REACH;
    for (uint32_t *slot = row; slot < row + kRow; slot += Slot::kWords) {
      before = *slot == 0 ? Slot::lowered(Level::REACH, before) : 0;
      Slot::set_distance(slot, before);
    }
    uint32_t behind = before;
    for (uint32_t *slot = row + kRow - Slot::kWords; slot > row;) {
      slot -= Slot::kWords;
      behind = Slot::lowered(Slot::distance(slot), behind);
      Slot::set_distance(slot, behind);
    }
  }

  /// The distances within one plane of cells; if it is too large for bytes, by a sweep forth and one back
  /// along x and y.
  static void measure_plane(uint32_t *plane) {
    using Distances = PlaneDistances<Level::SHAPE, Level::REACH>;
    if constexpr (Distances::kFits) {
      Distances().measure(plane, Slot::kWords, Slot::set_distance);
    } else {
      constexpr uint64_t kRow = Slot::kWords << Level::SHAPE.x;
      constexpr uint64_t kCells = uint64_t{1} << Level::SHAPE.x;
      constexpr uint64_t kPlane = kRow << Level::SHAPE.y;
      for (uint32_t *row = plane; row < plane + kPlane; row += kRow)
        measure_row(row);
      for (uint32_t *row = plane + kRow; row < plane + kPlane; row += kRow)
        lower(row, row - kRow, kCells);
      for (uint32_t *row = plane + kPlane - kRow; row > plane; row -= kRow)
        lower(row - kRow, row, kCells);
    }
  }
};

} // namespace voxc::construct
