// What one level of a format tells of a cell, and what it reads for that.
#pragma once

#include "RayPosition.h"
#include "ScenePath.h"

#include "voxc/Layout/SlotKind.h"
#include "voxc/Plan/Plan.h"

#include <cstdint>
#include <optional>

namespace voxc {

struct LevelView {
  LevelView(const Stratum &stratum, const Traversal &traversal, bool isFirst);

  const Stratum &stratum;
  Descent descent;
  bool isFirst;       ///< There is one sub-volume, the whole.
  int bottom;         ///< Cells have 2^bottom voxels a side,
  int top;            ///< and sub-volumes 2^top.
  int branch;         ///< Nodes have 2^branch children an axis.
  EmptyRegion region; ///< What it tells of the cells around an empty one.

  /// Layers of a tree that a look-up goes down, from a node of 2^from voxels a side to a cell of height `to`.
  int layers(int from, int to) const { return stratum.isGrid() ? 0 : (from - to + branch - 1) / branch; }
};

/// Different words that a look-up reads, which finds an empty cell or one with a voxel or more levels in it;
/// `layers` of a tree are gone down.
double wordsRead(const LevelView &level, int layers, bool isEmpty);

/// A number for the cache line that a look-up in a grid begins to read at, among those of its sub-volume, as
/// far as its words are laid out by the numbers of cells.
std::uint64_t lineOf(const LevelView &level, Int3 voxel);

/// The same of the slot of a cell that is not empty, where it is likely to lie on another line.
std::optional<std::uint64_t> slotLineOf(const LevelView &level, Int3 voxel);

/// What the level says of the position, which is empty in a cube of 2^empty voxels a side, to a traversal
/// that goes from cube to cube. Of an L1 distance, a cube in it if `asCube`, else the distance as the count.
EmptySpan spanAt(const LevelView &level, int empty, bool asCube, const RayPosition &at,
                 const ScenePath &path);

} // namespace voxc
