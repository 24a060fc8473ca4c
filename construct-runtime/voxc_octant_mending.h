// voxc_octant_mending.h: the empty cubes of a grid of which some cells became empty, or full.
#pragma once

#include "voxc_edited_dense.h"
#include "voxc_octant_cubes.h"

namespace voxc::construct {

template <typename Level> struct OctantMending {
  /// What an empty cell holds of which no more is known.
  static void set_empty(uint32_t *slot) {
    slot[0] = Level::DISTANCES_BESIDE ? 0 : Slot::kOnes;
    if constexpr (Level::DISTANCES_BESIDE)
      slot[1] = Slot::kOnes;
  }

  /// Makes the cubes right of all cells that those can change which became empty or full, and which `flipped`
  /// holds: of each octant the cells that lie behind them.
  static void mend(Edit &edit, uint32_t *grid, const CellBox &flipped) {
    constexpr int kReached = static_cast<int>(Level::REACH) - 1;
    const Voxel all = {kReached, kReached, kReached};
    touch_rows<Level::SHAPE>(edit, Level::NUMBER, grid, Slot::kWords,
                             flipped.template grown<Level::SHAPE>(all, all));
    for (unsigned octant = 0; octant < 8; ++octant) {
      const auto reached = [&](bool rises) { return rises ? kReached : 0; };
      const Voxel before = {reached((octant & 1) != 0), reached((octant & 2) != 0),
                            reached((octant & 4) != 0)};
      const Voxel behind = {kReached - before.x, kReached - before.y, kReached - before.z};
      mend_octant(grid, flipped.template grown<Level::SHAPE>(before, behind), octant);
    }
  }

private:
  using Slot = OctantSlot<Level>;

  /// The cubes of one octant from the cells of a box, those that lie farthest ahead first: one more than the
  /// least of the seven neighbours ahead, of which those outside of the box are right.
  static void mend_octant(uint32_t *grid, const CellBox &box, unsigned octant) {
    const unsigned shift = octant * Level::FIELD_BITS;
    const Voxel ahead = {(octant & 1) != 0 ? 1 : -1, (octant & 2) != 0 ? 1 : -1, (octant & 4) != 0 ? 1 : -1};
    for_each_in_order(box, {ahead.x < 0, ahead.y < 0, ahead.z < 0}, [&](Voxel cell) {
      uint32_t *const fields = Slot::fields(grid + Slot::kWords * Level::SHAPE.index(cell));
      if (!fields)
        return;
      uint32_t least = Level::REACH - 1;
      for (int i = 1; i < 8 && least > 0; ++i) {
        const Voxel at = {cell.x + (i & 1) * ahead.x, cell.y + (i >> 1 & 1) * ahead.y,
                          cell.z + (i >> 2) * ahead.z};
        const bool is_outside = (at.x | at.y | at.z) < 0 || Level::SHAPE.excludes(at);
        uint32_t *const slot = is_outside ? nullptr : grid + Slot::kWords * Level::SHAPE.index(at);
        const uint32_t side = Slot::side(slot, shift);
        least = side < least ? side : least;
      }
      *fields = (*fields & ~(Slot::kField << shift)) | (least + 1) << shift;
    });
  }
};

} // namespace voxc::construct
