// A NanoVDB grid where it lies: every offset is checked once, then cells are looked up.
#pragma once

#include "Input/NanoVdb/ValueKind.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/Transform.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace voxc {

/// A cube of cells of one value.
struct ValueTile {
  Int3 low;
  int log2Side = 0;
  double value = 0;
  bool isActive = false;
};

/// Coordinates of cells are those of the file, which may be negative.
class NanoVdbGrid {
public:
  /// `bytes` must outlive the grid. Errors: no grid of version 32 whose type is read; an offset that leads
  /// out of it, or nodes that are used more than once; interrupted.
  static Expected<NanoVdbGrid> open(std::span<const std::byte> bytes, const Progress &progress);

  const ValueKind &kind() const { return *kind_; }
  bool isLevelSet() const { return isLevelSet_; }
  /// Of a voxel's side, in the world.
  double voxelSize() const { return voxelSize_; }
  /// The least and the greatest active cell; the greatest is below the least if there is none.
  const Int3 &low() const { return low_; }
  const Int3 &high() const { return high_; }
  /// From index space, in which whole numbers are the middles of cells.
  const Transform &indexToWorld() const { return indexToWorld_; }

  /// Value and state of the cells from `cell` on along x, up to the end of the leaf or tile that they lie in:
  /// calls `visit(value, isActive)` for each of them, at most `count`. Returns how many.
  template <typename Visit> std::int32_t readRun(Int3 cell, std::int32_t count, Visit visit) const {
    const Place place = find(cell);
    const std::int32_t rest = (1 << place.log2Side) - (cell.x & ((1 << place.log2Side) - 1));
    const std::int32_t run = rest < count ? rest : count;
    for (std::int32_t i = 0; i < run; ++i) {
      const std::uint32_t slot = slotInLeaf({cell.x + i, cell.y, cell.z});
      if (place.leaf)
        visit(kind_->readCell(place.leaf, slot), isActiveInLeaf(place.leaf, slot));
      else
        visit(place.value, place.isActive);
    }
    return run;
  }

  /// Calls one of the two for each leaf, which begins at `low`, and for each cube that is none, the
  /// background left out.
  void forEach(const std::function<void(Int3 low, const std::byte *leaf)> &visitLeaf,
               const std::function<void(const ValueTile &tile)> &visitTile) const;

  double background() const { return background_; }

  /// The number of a cell in its leaf.
  static std::uint32_t slotInLeaf(Int3 cell) {
    return static_cast<std::uint32_t>((cell.x & 7) << 6 | (cell.y & 7) << 3 | (cell.z & 7));
  }

private:
  struct RootEntry {
    std::uint64_t key = 0;
    Int3 low;
    const std::byte *upper = nullptr; ///< Null: a tile.
    double value = 0;
    bool isActive = false;
  };
  /// Where a cell is stored: in a leaf, or in a tile of that size.
  struct Place {
    const std::byte *leaf = nullptr;
    int log2Side = 0;
    double value = 0;
    bool isActive = false;
  };
  class Checker;

  Place find(Int3 cell) const;

  const ValueKind *kind_ = nullptr;
  bool isLevelSet_ = false;
  double voxelSize_ = 1;
  double background_ = 0;
  Int3 low_;
  Int3 high_{-1, -1, -1};
  Transform indexToWorld_;
  std::vector<RootEntry> root_; ///< By key.
};

} // namespace voxc
