// voxc_l1_mending.h: L1 distances of a grid of which some cells became empty, or full.
#pragma once

#include "voxc_edited_dense.h"
#include "voxc_l1.h"

namespace voxc::construct {

template <typename Level> struct L1Mending {
  /// What an empty cell holds whose distance is not known: that the next one may be full.
  static void set_empty(uint32_t *slot) {
    slot[0] = 0;
    Slot::set_distance(slot, 1);
  }

  /// Makes the distances right of all cells that those can change which became empty or full, and which
  /// `flipped` holds: a sweep forth and one back along each axis.
  static void mend(Edit &edit, uint32_t *grid, const CellBox &flipped) {
    constexpr int kReached = Level::REACH < 1u << 21 ? static_cast<int>(Level::REACH) - 1 : 1 << 21;
    const Voxel reached = {kReached, kReached, kReached};
    const CellBox box = flipped.template grown<Level::SHAPE>(reached, reached);
    touch_rows<Level::SHAPE>(edit, Level::NUMBER, grid, Slot::kWords, box);
    for_each_in_order(box, {true, true, true}, [&](Voxel cell) {
      uint32_t *const slot = grid + Slot::kWords * Level::SHAPE.index(cell);
      if (EditedSlot<Level>::value(slot) == 0)
        Slot::set_distance(slot, Level::REACH);
    });
    constexpr Voxel kSteps[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const Voxel step : kSteps) {
      lower_box(grid, box, step, true);
      lower_box(grid, box, step, false);
    }
  }

private:
  using Slot = L1Slot<Level>;

  /// Lowers the distances of a box of cells to at most one more than those of the cells before them along an
  /// axis, which are `step` slots away, or behind them; also by those just outside of the box, which are
  /// right.
  static void lower_box(uint32_t *grid, const CellBox &box, Voxel step, bool forth) {
    const auto lower = [&](Voxel cell) {
      const Voxel before = forth ? Voxel{cell.x - step.x, cell.y - step.y, cell.z - step.z}
                                 : Voxel{cell.x + step.x, cell.y + step.y, cell.z + step.z};
      uint32_t *const slot = grid + Slot::kWords * Level::SHAPE.index(cell);
      const uint32_t distance = Slot::distance(slot);
      if (distance == 0 || (before.x | before.y | before.z) < 0 || Level::SHAPE.excludes(before))
        return;
      const uint32_t *const neighbour = grid + Slot::kWords * Level::SHAPE.index(before);
      Slot::set_distance(slot, Slot::lowered(distance, Slot::distance(neighbour)));
    };
    for_each_in_order(box, {forth, forth, forth}, lower);
  }
};

} // namespace voxc::construct
