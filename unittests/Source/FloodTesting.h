// Scenes with hollows, and what of them is hidden, cell by cell: slow, and by the definition.
#pragma once

#include "SourceTesting.h"

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

namespace voxc::test {

/// A grid of words in memory.
struct Grid {
  Int3 extent;
  std::vector<std::uint32_t> words;

  explicit Grid(Int3 size)
      : extent(size), words(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z)) {}

  std::uint32_t &at(Int3 cell) {
    return words[std::size_t(cell.x) +
                 std::size_t(extent.x) * (std::size_t(cell.y) + std::size_t(extent.y) * std::size_t(cell.z))];
  }
  std::uint32_t at(Int3 cell) const { return const_cast<Grid &>(*this).at(cell); }

  /// Calls `visit(cell)` for every cell.
  template <typename Visit> void forEach(Visit visit) const {
    for (Int3 cell; cell.z < extent.z; ++cell.z)
      for (cell.y = 0; cell.y < extent.y; ++cell.y)
        for (cell.x = 0; cell.x < extent.x; ++cell.x)
          visit(cell);
  }
};

inline Voxels voxelsOf(const Grid &grid) {
  Voxels voxels;
  grid.forEach([&](Int3 cell) {
    if (const std::uint32_t word = grid.at(cell))
      voxels[mortonCode(cell)] = word;
  });
  return voxels;
}

/// Boxes of voxels and boxes that are cut out of them again, then holes and dust: there are hollows of every
/// size, and some of them leak through a face, an edge or a corner.
inline Grid hollowGrid(Int3 extent, unsigned seed) {
  std::mt19937 random(seed);
  Grid grid(extent);
  const auto below = [&](int end) { return static_cast<int>(random() % static_cast<unsigned>(end)); };
  const auto paintBox = [&](std::uint32_t word) {
    Int3 low;
    Int3 high;
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = below(extent[axis]);
      high[axis] = std::min(extent[axis], low[axis] + 1 + below(1 + extent[axis] / 2));
    }
    for (Int3 cell = low; cell.z < high.z; ++cell.z)
      for (cell.y = low.y; cell.y < high.y; ++cell.y)
        for (cell.x = low.x; cell.x < high.x; ++cell.x)
          grid.at(cell) = word;
  };
  for (std::uint32_t i = 1; i <= 24; ++i)
    paintBox(i % 3 == 2 ? 0 : 0xff000000 + i);
  const unsigned dust = 1 + random() % 40;
  grid.forEach([&](Int3 cell) {
    if (random() % 100 < dust / 8)
      grid.at(cell) = grid.at(cell) == 0 ? 0xff0000ff : 0;
  });
  return grid;
}

/// Cells of which each is a voxel with a chance of `percent` in 100.
inline Grid dustGrid(Int3 extent, unsigned percent, unsigned seed) {
  std::mt19937 random(seed);
  Grid grid(extent);
  for (std::uint32_t &word : grid.words)
    word = random() % 100 < percent ? 0xff000001 + static_cast<std::uint32_t>(random() % 3) : 0;
  return grid;
}

/// The steps of a path over faces.
inline std::vector<Int3> faceSteps() {
  return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
}

/// The steps of rays: up or down on any axes at once.
inline std::vector<Int3> raySteps() {
  std::vector<Int3> steps;
  for (int axes = 1; axes < 8; ++axes) {
    const Int3 up{axes & 1, axes >> 1 & 1, axes >> 2};
    steps.push_back(up);
    steps.push_back(up * -1);
  }
  return steps;
}

/// Which cells steps over empty cells from outside come to, voxels too: 1 for each, in the order of a grid.
inline std::vector<char> touchedFromOutside(const Grid &grid, const std::vector<Int3> &steps) {
  // A border of empty cells around all.
  Grid wide(grid.extent + Int3{2, 2, 2});
  grid.forEach([&](Int3 cell) { wide.at(cell + Int3{1, 1, 1}) = grid.at(cell); });
  Grid touched(wide.extent);
  std::vector<Int3> front{{}};
  touched.at({}) = 1;
  while (!front.empty()) {
    const Int3 cell = front.back();
    front.pop_back();
    for (const Int3 &step : steps) {
      const Int3 next = cell + step;
      if (!contains(wide.extent, next) || touched.at(next) != 0)
        continue;
      touched.at(next) = 1;
      if (wide.at(next) == 0)
        front.push_back(next);
    }
  }
  std::vector<char> flags;
  grid.forEach([&](Int3 cell) { flags.push_back(touched.at(cell + Int3{1, 1, 1}) != 0); });
  return flags;
}

} // namespace voxc::test
