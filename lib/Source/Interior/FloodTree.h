// Flooding the empty cells of a source: which of them a path reaches, and which voxels it comes to.
#pragma once

#include "Source/BrickBits.h"
#include "Source/Interior/BrickCells.h"
#include "voxc/Source/Interior.h"
#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/WorkingMemory.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace voxc {

/// From which cell to which a path goes.
enum class Step : std::uint8_t {
  Face, ///< To the six cells that share a face.
  Ray,  ///< As rays go: up, or down, on one, two or all three axes at once. By the definition of the hit,
       ///< coordinates that change at one moment either all rise or all fall, falling ones after rising ones.
};

/// What lies outside the extent of a source.
enum class Outside : std::uint8_t { Empty, Solid };

/// How a tree is flooded.
struct Flood {
  Step step = Step::Face;
  Outside outside = Outside::Empty;
};

/// Which cells of a flooded tree make a set, and what is counted of them.
enum class Choice : std::uint8_t {
  Reached,            ///< Empty cells that the flood fill has reached.
  Unreached,          ///< Empty cells that it has not.
  UnreachedAndVoxels, ///< These, and the voxels that it has not come to; the voxels are counted.
};

/// The cells of a source, empty or voxels, as a tree of 8^3: cubes that are empty or full as a whole are one
/// child of their node, however large; where both meet there are bricks of 8^3 cells with a bit for each. So
/// memory follows the surface, and a brick is flooded by shifting words of 64 bits. What is reached depends
/// on nothing but the voxels and where the flood fill begins.
class FloodTree {
public:
  /// Reads all of `source`. Errors: that of a source that fails, interrupted, no memory.
  static Expected<FloodTree> read(VoxelSource &source, const Flood &flood, const InteriorOptions &options);

  /// Floods all empty cells that a path from outside the tree's cube reaches. Errors: interrupted, no memory.
  Expected<void> floodFromOutside();
  /// Floods those that a path from `cell` reaches, which is empty.
  Expected<void> floodFrom(Int3 cell);
  /// A cell of each part of the empty cells that is not connected with the others, by `Step`, in Morton
  /// order: all of them are flooded.
  Expected<ScratchArray<Int3>> floodEveryPart();
  /// Makes all reached cells empty again.
  void clearReached();

  struct Chosen {
    std::shared_ptr<const CellSet> cells;
    std::uint64_t count = 0;
  };
  Expected<Chosen> choose(Choice choice) const;

  /// The voxels of the source, in Morton order. Error: no memory.
  Expected<ScratchArray<BrickCells>> voxels() const;

private:
  /// What stands for a child that is no node: the others are kFirst and the index of a node or leaf.
  enum Child : std::uint32_t { kEmpty, kReached, kFull, kFirst };
  using Node = CellSet::Node;

  struct Leaf {
    Slices voxels;
    Slices touched; ///< Reached, or a voxel that the flood fill comes to.
    Int3 low;
    std::uint32_t isWaiting; ///< To be flooded.
  };

  /// A cube of 8^height cells a side that the flood fill has reached: a leaf, or one that is empty.
  struct ReachedCube {
    Int3 low;
    int height;
    std::uint32_t leaf; ///< Or kNoLeaf.
  };
  static constexpr std::uint32_t kNoLeaf = ~std::uint32_t{0};

  /// The cells from `low` up to below `high`; of a brick only those of `cells`, if there are any given.
  struct Region {
    Int3 low;
    Int3 high;
    const Slices *cells = nullptr;
  };

  /// A node of `kChunkHeight` that is read later, perhaps by another thread: a child of a node.
  struct Chunk {
    std::uint32_t node;
    std::uint32_t place;
    Int3 low;
  };
  static constexpr int kChunkHeight = 2;

  FloodTree(const Flood &flood, std::shared_ptr<WorkingMemory> memory, const Progress &progress)
      : step_(flood.step), outside_(flood.outside), progress_(progress), memory_(std::move(memory)),
        nodes_(memory_), leaves_(memory_), waiting_(memory_) {}

  // Reading.
  bool isWhole(VoxelSource &source, const Cube &cube, std::uint32_t &child) const;
  std::uint32_t readCube(VoxelSource &source, Int3 low, int height);
  void readChildren(VoxelSource &source, const Cube &cube, std::uint32_t node, int height);
  std::uint32_t readBrick(VoxelSource &source, Int3 low);
  void readChunks(VoxelSource &source, std::span<const Chunk> chunks, unsigned threads);
  void join(FloodTree &part, std::uint32_t child, const Chunk &chunk);

  // Flooding. Each `touch` of a child returns what it is from now on.
  void touch(const Region &region);
  std::uint32_t touchChild(std::uint32_t child, Int3 low, int height, const Region &region);
  void touchNode(std::uint32_t node, Int3 low, int height, const Region &region);
  void touchLeaf(std::uint32_t leaf, const Slices &cells);
  Expected<void> run();
  void spread(const ReachedCube &cube);
  void spread(std::uint32_t leaf);
  void floodUnreached(std::uint32_t child, Int3 low, int height, ScratchArray<Int3> &parts);

  std::uint32_t chooseChild(std::uint32_t child, int height, Choice choice, CellSet &cells,
                            std::uint64_t &count, std::optional<Error> &error) const;

  void listVoxels(std::uint32_t child, const Cube &cube, int height, ScratchArray<BrickCells> &bricks,
                  std::optional<Error> &error) const;

  std::uint32_t addNode(std::uint32_t children);
  std::uint32_t addLeaf(Int3 low, const Slices &voxels);
  void check(const Expected<void> &done) {
    if (!done && !error_)
      error_ = done.error();
  }
  bool isStopped();

  Step step_;
  Outside outside_;
  Progress progress_;
  std::shared_ptr<WorkingMemory> memory_;
  Int3 extent_;
  int height_ = 1; ///< Of the root, whose cube has 8^height cells a side.
  ScratchArray<Node> nodes_;
  ScratchArray<Leaf> leaves_;
  ScratchArray<ReachedCube> waiting_;
  ScratchArray<Chunk> *chunks_ =
      nullptr; ///< Where to put off chunks while a source is read by several threads.
  std::uint32_t root_ = kEmpty;
  std::uint64_t steps_ = 0; ///< Of the work, between two looks at whether to stop.
  std::optional<Error> error_;
};

} // namespace voxc
