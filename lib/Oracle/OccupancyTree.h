// Which cells are empty, as a tree of 4^3 children a node and a bit a child: how large the empty cube around
// a cell is, in a few loads.
#pragma once

#include "voxc/Support/Geometry.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace voxc {

/// Memory follows the surface of what is not empty: 24 bytes for each 4^3 cells that are neither all empty
/// nor all full, and as much for the few nodes above.
class OccupancyTree {
public:
  OccupancyTree() = default;
  /// The tree over the cells [0, 2^log2Side)^3. `changes` rise strictly: the cells in Morton order are empty
  /// up to that with the code changes[0], not empty from there to changes[1], empty up to changes[2], ...
  OccupancyTree(std::span<const std::uint64_t> changes, int log2Side);

  /// log2 of the side of an aligned empty cube around `cell`, which may reach beyond the tree, where all is
  /// empty; nothing if the cell is not empty. No coordinate is below 0.
  std::optional<int> emptyAround(Int3 cell) const;

private:
  /// Children are numbered in Morton order: six bits, of which the upper three say the octant.
  struct Node {
    std::uint64_t occupied = 0; ///< Children that are not all empty.
    std::uint64_t mixed = 0;    ///< Of these, those with empty cells too: they are nodes.
    std::uint64_t firstChild = 0;
  };

  std::vector<Node> nodes_{1}; // Level by level from the root; the children of a node stand together.
  int log2Side_ = 2;           // Even.
};

} // namespace voxc
