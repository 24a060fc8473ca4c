// voxc_octant_cubes.h: for each empty cell of a grid and each octant of directions, the side of the largest
// empty cube that begins in the cell and goes that way.
#pragma once

#include "voxc_dense.h"

namespace voxc::construct {

/// The fields of a cell: one for each octant, in the word of an empty cell, or in a word beside its value.
template <typename Level> struct OctantSlot {
  static constexpr uint64_t kWords = Level::SLOT_WORDS;
  static constexpr uint32_t kField = Level::FIELD_MASK;
  /// Cubes of one cell, in all directions.
  static constexpr uint32_t kOnes = Level::FIELD_BITS == 4 ? 0x11111111u : 011111111u;
  /// What lies outside of the grid is empty, or not known, and taken to be full.
  static constexpr uint32_t kOutside = Level::FIRST ? Level::REACH : 0;

  /// Null of a cell that is not empty.
  static uint32_t *fields(uint32_t *slot) {
    if constexpr (Level::DISTANCES_BESIDE)
      return slot[0] == 0 ? slot + 1 : nullptr;
    else
      return SlotWord<Level>::is_empty(*slot) ? slot : nullptr;
  }
  /// The field of an octant, which stands `shift` bits up, in a slot; null is outside.
  static uint32_t side(uint32_t *slot, unsigned shift) {
    if (!slot)
      return kOutside;
    const uint32_t *const own = fields(slot);
    return own ? *own >> shift & kField : 0;
  }
};

/// Plane after plane, there and back, so that a grid may be larger than memory.
template <typename Level> struct OctantField {
  static void measure(Build &build, uint32_t *grid) {
    constexpr uint64_t kPlane = Slot::kWords << (Level::SHAPE.x + Level::SHAPE.y);
    constexpr int kDepth = 1 << Level::SHAPE.z;
    for (int z = 0; z < kDepth; ++z) {
      uint32_t *plane = grid + kPlane * static_cast<uint64_t>(z);
      clear_plane(plane);
      measure_plane(plane, z > 0 ? plane - kPlane : nullptr, 0);
      build.pause(2 * kPlane);
    }
    for (int z = kDepth - 1; z >= 0; --z) {
      uint32_t *plane = grid + kPlane * static_cast<uint64_t>(z);
      measure_plane(plane, z < kDepth - 1 ? plane + kPlane : nullptr, 1);
      build.pause(2 * kPlane);
    }
  }

private:
  using Slot = OctantSlot<Level>;

  /// A cube of one cell in all directions, to begin with.
  static void clear_plane(uint32_t *plane) {
    constexpr uint64_t kCells = uint64_t{1} << (Level::SHAPE.x + Level::SHAPE.y);
    for (uint32_t *slot = plane; slot < plane + Slot::kWords * kCells; slot += Slot::kWords) {
      if constexpr (Level::DISTANCES_BESIDE)
        slot[1] = slot[0] == 0 ? Slot::kOnes : 0;
      else
        slot[0] = slot[0] == 0 ? Slot::kOnes : slot[0];
    }
  }

  /// The cubes of one octant from the cells of a row: one more than the least of the seven neighbours that
  /// lie ahead. `rows` are the row and its three neighbours ahead, null outside of the grid.
  static void measure_row(uint32_t *const (&rows)[4], unsigned octant) {
    constexpr int kWidth = 1 << Level::SHAPE.x;
    const unsigned shift = octant * Level::FIELD_BITS;
    uint32_t ahead = Slot::kOutside; // The least of the four cells before this one.
    for (int i = 0; i < kWidth; ++i) {
      const uint64_t at = Slot::kWords * static_cast<uint64_t>((octant & 1) != 0 ? kWidth - 1 - i : i);
      uint32_t aside = Level::REACH;
      for (int row = 1; row < 4; ++row) {
        const uint32_t side = Slot::side(rows[row] ? rows[row] + at : nullptr, shift);
        aside = side < aside ? side : aside;
      }
      uint32_t side = 0;
      if (uint32_t *const fields = Slot::fields(rows[0] + at)) {
        side = 1 + (aside < ahead ? aside : ahead);
        side = side < Level::REACH ? side : Level::REACH;
        *fields = (*fields & ~(Slot::kField << shift)) | side << shift;
      }
      ahead = side < aside ? side : aside;
    }
  }

  /// The four octants in which z rises, or falls, within a plane whose neighbour that way is `beyond`, null
  /// outside of the grid.
  static void measure_plane(uint32_t *plane, uint32_t *beyond, unsigned z_rises) {
    constexpr int kHeight = 1 << Level::SHAPE.y;
    constexpr uint64_t kRow = Slot::kWords << Level::SHAPE.x;
    for (unsigned octant = 4 * z_rises; octant < 4 * z_rises + 4; ++octant)
      for (int i = 0; i < kHeight; ++i) {
        const bool y_rises = (octant & 2) != 0;
        const uint64_t at = kRow * static_cast<uint64_t>(y_rises ? kHeight - 1 - i : i);
        const uint64_t next = y_rises ? at + kRow : at - kRow;
        uint32_t *const rows[4] = {plane + at, i > 0 ? plane + next : nullptr, beyond ? beyond + at : nullptr,
                                   i > 0 && beyond ? beyond + next : nullptr};
        measure_row(rows, octant);
      }
  }
};

} // namespace voxc::construct
