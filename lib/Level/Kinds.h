// The base formats, each described in the file of its name, and what they share.
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/Volume/SubVolume.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <string>

namespace voxc {

extern const LevelKind kRaw;
extern const LevelKind kDistance;
extern const LevelKind kSvo;
extern const LevelKind kSvdag;

/// The masks of a tree's node: bit i of the low byte says that child i is not empty, of the next that it is a
/// leaf.
struct NodeMasks {
  std::uint32_t word;

  bool valid(int child) const { return word >> child & 1; }
  bool leaf(int child) const { return word >> (8 + child) & 1; }
  /// Non-empty children before `child`; with 8, all of them.
  std::uint32_t rank(int child) const {
    return static_cast<std::uint32_t>(std::popcount(word & 0xff & ((1u << child) - 1)));
  }
};

/// Child i = x + 2y + 4z of a node that covers 2^height cells, around `cell`.
inline int childIndex(Int3 cell, int height) {
  const Int3 bits = cell >> (height - 1);
  return (bits.x & 1) | (bits.y & 1) << 1 | (bits.z & 1) << 2;
}

/// The low corner of child i, from that of its parent of 2^height cells.
inline Int3 childLow(Int3 low, int child, int height) {
  const int side = 1 << (height - 1);
  return low + Int3{child & 1, child >> 1 & 1, child >> 2 & 1} * side;
}

/// Notes masks that no builder writes: bits of no meaning, leaves that are empty, no child at all, or inner
/// nodes where only cells can be.
void checkMasks(WordReader &words, NodeMasks masks, int height);

/// Index of a cell in a grid stored x fastest, then y, then z.
inline std::uint64_t cellIndex(Int3 log2Size, Int3 cell) {
  return static_cast<std::uint64_t>(cell.x) +
         ((static_cast<std::uint64_t>(cell.y) + (static_cast<std::uint64_t>(cell.z) << log2Size.y))
          << log2Size.x);
}

/// Replaces a pointer by its new offset. False if there is none.
inline bool relocatePointer(std::uint32_t &pointer, std::span<const std::uint32_t> newOffsets) {
  pointer = pointer < newOffsets.size() ? newOffsets[pointer] : 0;
  return pointer != 0;
}

/// The same for the terminating integers of a grid, `step` words apart; 0 is an empty cell and stays.
inline bool relocateCells(std::span<std::uint32_t> words, std::size_t step, bool holdsVoxels,
                          std::span<const std::uint32_t> newOffsets) {
  for (std::size_t i = 0; i < words.size() && !holdsVoxels; i += step)
    if (words[i] != 0 && !relocatePointer(words[i], newOffsets))
      return false;
  return true;
}

/// Visits the cells of a grid of log2 size in Morton order; aligned cubes outside the grid are never entered.
template <typename Visit> void forEachCell(Int3 log2Size, Int3 low, int log2Side, Visit &&visit) {
  for (int axis = 0; axis < 3; ++axis)
    if (low[axis] >> log2Size[axis] != 0)
      return;
  if (log2Side == 0)
    return visit(low);
  for (int child = 0; child < 8; ++child)
    forEachCell(log2Size, childLow(low, child, log2Side), log2Side - 1, visit);
}

} // namespace voxc
