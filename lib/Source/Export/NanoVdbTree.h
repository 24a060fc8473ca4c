// What a NanoVDB tree of a volume will consist of, found in one traversal over its voxels.
#pragma once

#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/WorkingMemory.h"
#include "voxc/Volume/Volume.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

namespace voxc {

/// The box of active cells: the least and the greatest.
struct ActiveBox {
  Int3 low{std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::max(),
           std::numeric_limits<std::int32_t>::max()};
  Int3 high{-1, -1, -1};

  void add(const ActiveBox &other) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], other.low[axis]);
      high[axis] = std::max(high[axis], other.high[axis]);
    }
  }
  bool isEmpty() const { return high.x < 0; }
};

/// A child of a node: cells of one value, or a node that follows in its own list.
struct TreeChild {
  Int3 low;
  std::uint32_t tile = 0; ///< The value of all its cells; 0: it is a node.
};

/// An upper or a lower node, whose children are a range of the list below it.
struct TreeNode {
  Int3 low;
  std::uint32_t children = 0;
  std::uint64_t firstChild = 0;
  std::uint64_t firstNode = 0; ///< How many nodes stand before the first of its own children that is one.
  ActiveBox box;
};

/// Lists in Morton order. Children of the root are uppers and tiles of 4096^3 cells, and so on.
struct NanoVdbTree {
  explicit NanoVdbTree(const std::shared_ptr<WorkingMemory> &memory)
      : root(memory), uppers(memory), ofUppers(memory), lowers(memory), ofLowers(memory) {}

  ScratchArray<TreeChild> root;
  ScratchArray<TreeNode> uppers;
  ScratchArray<TreeChild> ofUppers;
  ScratchArray<TreeNode> lowers;
  ScratchArray<TreeChild> ofLowers;
  std::uint64_t leaves = 0;
  std::array<std::uint64_t, 3> tiles{}; ///< Of lower and upper nodes, and of the root.
  std::uint64_t voxels = 0;
  ActiveBox box;
};

/// Errors: interrupted; no memory.
Expected<NanoVdbTree> findNanoVdbTree(const Volume &volume, const std::shared_ptr<WorkingMemory> &memory,
                                      const Progress &progress);

/// The 512 words of the brick at `low` in Morton order, those outside the extent 0. Errors: the source's.
Expected<void> readBrickWithin(VoxelSource &source, Int3 low, std::array<std::uint32_t, 512> &words);

} // namespace voxc
