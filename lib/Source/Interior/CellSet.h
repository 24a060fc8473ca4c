// A set of cells, as a tree of 8^3 in which cubes that lie in it or outside it as a whole end a branch.
#pragma once

#include "Source/BrickBits.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Support/WorkingMemory.h"

#include <array>
#include <cstdint>
#include <memory>

namespace voxc {

/// Made once, then asked by any number of threads. A leaf is a brick of 8^3 cells; a node of height h has 8^3
/// children of 8^(h-1) cells a side, in Morton order. Memory is that of a `WorkingMemory`.
class CellSet {
public:
  /// What stands for a child that is no node: the others are kFirst and the index of a node or leaf.
  enum Child : std::uint32_t { kNone, kAll, kFirst };
  static constexpr int kLog2Brick = 3;
  using Node = std::array<std::uint32_t, 512>;

  explicit CellSet(std::shared_ptr<WorkingMemory> memory)
      : memory_(std::move(memory)), nodes_(memory_), leaves_(memory_) {}

  /// Adds a node or a leaf and returns what its parent calls it.
  Expected<std::uint32_t> add(const Node &children);
  Expected<std::uint32_t> add(const MortonBits &cells);
  /// Ends the adding: the root, a node or a leaf or a whole cube of 8^height cells a side at the origin.
  void finish(std::uint32_t root, int height) {
    root_ = root;
    height_ = height;
  }

  /// True if none of the cells of an aligned cube is in the set; if all are. Cells outside the root are not.
  bool none(const Cube &cube) const { return is(cube, kNone); }
  bool all(const Cube &cube) const { return is(cube, kAll); }

  /// Sets the words of those cells of an aligned cube of at most 8^3 that are in the set; words as
  /// `VoxelSource::read` orders them.
  void paint(const Cube &cube, std::uint32_t word, std::uint32_t *words) const;

private:
  /// A child on the way down, and what it is.
  struct Place {
    std::uint32_t child;
    int height;
  };

  /// The smallest node, leaf or whole cube that holds `cube`.
  Place find(const Cube &cube) const;
  bool is(const Cube &cube, std::uint32_t whole) const;

  std::shared_ptr<WorkingMemory> memory_;
  ScratchArray<Node> nodes_;
  ScratchArray<MortonBits> leaves_;
  std::uint32_t root_ = kNone;
  int height_ = 1;
};

} // namespace voxc
