// Distances in the cells of sub-volumes.
#include "DistanceFields.h"

#include <algorithm>
#include <array>
#include <bit>

namespace voxc {
namespace {

constexpr unsigned kAllOctants = 8;
constexpr int kFar = 255;

/// Where the cells of a field lie.
struct Grid {
  int log2Side;

  int side() const { return 1 << log2Side; }
  std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>(x + (y << log2Side)) + (static_cast<std::size_t>(z) << 2 * log2Side);
  }
  bool contains(int x, int y, int z) const { return ((x | y | z) & ~(side() - 1)) == 0; }
};

/// Lowers distances to the nearest 0: a sweep there and one back along each axis, since L1 distances are
/// separable.
void measureL1(Grid grid, std::vector<std::uint8_t> &field) {
  const std::array<std::size_t, 3> strides = {grid.index(1, 0, 0), grid.index(0, 1, 0), grid.index(0, 0, 1)};
  const auto lower = [&](std::size_t cell, std::size_t neighbour) {
    field[cell] = static_cast<std::uint8_t>(std::min<int>(field[cell], field[neighbour] + 1));
  };
  for (unsigned axis = 0; axis < 3; ++axis) {
    const auto place = [&](std::size_t cell) {
      return cell / strides[axis] & static_cast<std::size_t>(grid.side() - 1);
    };
    for (std::size_t cell = 0; cell < field.size(); ++cell)
      if (place(cell) > 0)
        lower(cell, cell - strides[axis]);
    for (std::size_t cell = field.size(); cell-- > 0;)
      if (place(cell) + 1 < static_cast<std::size_t>(grid.side()))
        lower(cell, cell + strides[axis]);
  }
}

/// A cell's empty cube in an octant is one larger than the smallest of the seven ahead of it; beyond the grid
/// they are `outside`. One sweep from the far corner does.
void measureCubes(Grid grid, unsigned octant, int outside, std::vector<std::uint8_t> &field) {
  const auto rises = [&](unsigned axis) { return (octant >> axis & 1) != 0; };
  const auto place = [&](int turn, unsigned axis) { return rises(axis) ? grid.side() - 1 - turn : turn; };
  const auto ahead = [&](int place, bool moves, unsigned axis) {
    return place + (!moves ? 0 : rises(axis) ? 1 : -1);
  };
  for (int k = 0; k < grid.side(); ++k)
    for (int j = 0; j < grid.side(); ++j)
      for (int i = 0; i < grid.side(); ++i) {
        const int x = place(i, 0);
        const int y = place(j, 1);
        const int z = place(k, 2);
        std::uint8_t &cell = field[grid.index(x, y, z)];
        int least = cell == 0 ? -1 : cell - 1;
        for (unsigned way = 1; way < 8 && least > 0; ++way) {
          const int a = ahead(x, (way & 1) != 0, 0);
          const int b = ahead(y, (way & 2) != 0, 1);
          const int c = ahead(z, (way & 4) != 0, 2);
          least = std::min<int>(least, grid.contains(a, b, c) ? field[grid.index(a, b, c)] : outside);
        }
        cell = static_cast<std::uint8_t>(least + 1);
      }
}

/// Marks the cells of a cube that are not empty; `low` and sides are in cells, of which an axis has 2^log2.
void mark(const SceneDag &dag, int bottom, int height, std::size_t number, Int3 low, int log2,
          std::vector<std::uint8_t> &cells) {
  if (height == bottom) {
    cells[static_cast<std::size_t>(low.x + (low.y << log2)) + (static_cast<std::size_t>(low.z) << 2 * log2)] =
        1;
    return;
  }
  const SceneDag::Node node = dag.node(height, number);
  std::uint32_t mask = node.mask;
  for (const std::uint32_t child : node.children) {
    const auto place = mortonCell(static_cast<std::uint64_t>(std::countr_zero(mask)));
    mask &= mask - 1;
    mark(dag, bottom, height - 1, child, low + place * (1 << (height - 1 - bottom)), log2, cells);
  }
}

} // namespace

int DistanceFields::at(const SubVolume &in, Int3 cell, unsigned octant) {
  const bool isL1 = in.stratum.skip == Skip::L1;
  const Key key{in.stratum.log2Cell, in.top, in.number, isL1 ? kAllOctants : octant, in.stratum.reach};
  Field &field = fields_[key];
  if (field.empty())
    field = measure(in, isL1 ? kAllOctants : octant);
  const int log2 = in.top - in.stratum.log2Cell;
  return field[static_cast<std::size_t>(cell.x + (cell.y << log2)) +
               (static_cast<std::size_t>(cell.z) << 2 * log2)];
}

DistanceFields::Field DistanceFields::occupancyOf(const SubVolume &in) const {
  const int log2 = in.top - in.stratum.log2Cell;
  Field cells(std::size_t{1} << 3 * log2);
  mark(dag_, in.stratum.log2Cell, in.top, in.number, {}, log2, cells);
  return cells;
}

DistanceFields::Field DistanceFields::measure(const SubVolume &in, unsigned octant) const {
  Field field = occupancyOf(in);
  const auto reach = static_cast<std::uint8_t>(std::min<std::uint32_t>(in.stratum.reach, kFar));
  for (std::uint8_t &cell : field)
    cell = cell != 0 ? 0 : reach;
  const Grid grid{in.top - in.stratum.log2Cell};
  if (octant == kAllOctants)
    measureL1(grid, field);
  else
    measureCubes(grid, octant, in.isWhole ? reach : 0, field);
  return field;
}

} // namespace voxc
