// Counting the cells of a node of a tree: what kinds of slots with masks of children and leaves share.
#pragma once

#include "Masks.h"

#include <bit>
#include <cstdint>

namespace voxc {

/// The cells that are not empty in a checked node of 64 children at most, or 0 where something is wrong.
/// `leaf(i)`: whether slot i, that of a leaf, has a value. `node(i)`: the cells of the child of slot i, or 0.
template <typename Leaf, typename Node>
std::uint64_t countTree(const Stratum &stratum, const Masks &masks, int layer, Leaf &&leaf, Node &&node) {
  const std::uint64_t leaves = layer == 1 ? masks.all() : masks.allLeaves();
  const std::uint64_t cellsOfLeaf = std::uint64_t{1} << stratum.log2Children() * (layer - 1);
  std::uint64_t slot = 0;
  std::uint64_t sum = 0;
  for (std::uint64_t rest = masks.all(); rest != 0; rest &= rest - 1) {
    const bool isLeaf = (leaves >> std::countr_zero(rest) & 1) != 0;
    if (isLeaf && stratum.implied) {
      sum += cellsOfLeaf;
      continue;
    }
    const std::uint64_t cells = !isLeaf ? node(slot) : leaf(slot) ? cellsOfLeaf : 0;
    if (cells == 0)
      return 0;
    sum += cells;
    ++slot;
  }
  return sum;
}

} // namespace voxc
