// voxc_grid.h: construction of grids: their cells, in the order of the voxels. A level is a struct of
// constants.
#pragma once

#include "voxc_construct.h"

namespace voxc::construct {

/// The shape of a grid: log2 of its cells along each axis, and of the voxels along a cell's side; whether its
/// cells hold voxels, or sub-volumes, which may be as small.
struct GridShape {
  int x;
  int y;
  int z;
  int log2_cell;
  bool holds_voxels;

  constexpr uint64_t cells() const { return uint64_t{1} << (x + y + z); }
  constexpr int longest() const { return x > y ? (x > z ? x : z) : (y > z ? y : z); }
  constexpr bool excludes(Voxel cell) const { return (cell.x >> x | cell.y >> y | cell.z >> z) != 0; }
  /// The place of a cell: x fastest, then y, then z.
  constexpr uint64_t index(Voxel cell) const {
    const auto row = static_cast<uint64_t>(cell.y) + (static_cast<uint64_t>(cell.z) << y);
    return static_cast<uint64_t>(cell.x) + (row << x);
  }
};

/// Visits the voxels of a brick that are not empty, as placed cells, as far as they lie in the 2^height a
/// side at `cell` of a grid of voxels.
template <GridShape kShape, typename Visit>
void for_each_voxel(Build &build, Voxel corner, Voxel cell, int height, Visit &visit) {
  const Brick &brick = build.brick(corner);
  const unsigned first = brick_index(corner);
  const unsigned count = 1u << 3 * height;
  const unsigned piece = count < 64 ? count : 64;
  for (unsigned begin = 0; begin < count; begin += piece)
    for (uint64_t filled = brick.filled_from(first + begin, piece); filled != 0;) {
      const unsigned i = begin + take_bit(filled);
      const Voxel step = brick_voxel(i);
      const Voxel at = {cell.x + step.x, cell.y + step.y, cell.z + step.z};
      if (!kShape.excludes(at))
        visit(PlacedCell{at, brick.voxels[first + i]});
    }
}

/// Visits the cells of a grid that are not empty, as placed cells, in Morton order of its bounding cube:
/// cells outside a grid that is no cube are skipped a whole aligned cube at a time, and so are empty ones.
/// `low` is the corner of the grid, `cell` that, in cells, of the 2^height a side to visit.
template <typename Level, typename Visit>
void for_each_cell(Build &build, Voxel low, Voxel cell, int height, Visit &visit) {
  constexpr GridShape kShape = Level::SHAPE;
  constexpr int kLog2Cell = kShape.log2_cell;
  constexpr bool kCellsAreVoxels = kShape.holds_voxels;
  const Voxel corner = {low.x + (cell.x << kLog2Cell), low.y + (cell.y << kLog2Cell),
                        low.z + (cell.z << kLog2Cell)};
  if (kShape.excludes(cell) || build.is_empty(corner, height + kLog2Cell))
    return;
  if ((height > 0 || kCellsAreVoxels) && build.is_part(height + kLog2Cell)) {
    const Part part = build.take_part(corner);
    for (uint64_t i = 0; i < part.cell_count; ++i)
      visit(part.cells[i]);
  } else if (kCellsAreVoxels && height <= kLog2Brick) {
    for_each_voxel<kShape>(build, corner, cell, height, visit);
  } else if (height == 0) {
    const uint32_t before = build.values();
    if (const uint32_t value = Level::Cells::construct(build, corner))
      visit(PlacedCell{cell, value, build.values() - before});
  } else {
    for (unsigned i = 0; i < 8; ++i)
      for_each_cell<Level>(build, low, child_low(cell, i, height - 1), height - 1, visit);
  }
}

/// What grids of all kinds have.
template <typename Level> struct GridPart {
  static constexpr int kLog2Cell = Level::SHAPE.log2_cell;

  /// Hands over the cells of the aligned cube of 2^log2_side voxels a side at `corner`, built apart.
  static void part(Build &build, Voxel corner, int log2_side) {
    // A grid that is no cube is the only one of its level, and stands at the origin.
    constexpr int kInside = (1 << (Level::SHAPE.longest() + kLog2Cell)) - 1;
    const Voxel cell = {(corner.x & kInside) >> kLog2Cell, (corner.y & kInside) >> kLog2Cell,
                        (corner.z & kInside) >> kLog2Cell};
    const Voxel low = {corner.x & ~kInside, corner.y & ~kInside, corner.z & ~kInside};
    auto finish = [&](const PlacedCell &cell) { build.finish(cell); };
    for_each_cell<Level>(build, low, cell, log2_side - kLog2Cell, finish);
  }
};

/// Writes the words of a grid, in a level that shares grids only if they are not written already. Returns
/// what leads to them.
template <typename Level> uint32_t put_words(Build &build, const uint32_t *words, uint64_t count) {
  return Level::INTERNS ? build.intern(Level::NUMBER, words, count)
                        : build.append(Level::NUMBER, words, count);
}

/// Writes a field of `bits` bits, 32 at most, from bit `at` of words that are 0 there.
inline void put_bits(uint32_t *words, uint64_t at, unsigned bits, uint32_t field) {
  const uint64_t shifted = uint64_t{field} << at % 32;
  words[at / 32] |= static_cast<uint32_t>(shifted);
  if (at % 32 + bits > 32)
    words[at / 32 + 1] |= static_cast<uint32_t>(shifted >> 32);
}

} // namespace voxc::construct
