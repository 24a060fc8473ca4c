// voxc_host.h: what the program that builds a volume and the generated code that arranges it hand to each
// other. Freestanding: no library, no other header.
#pragma once

namespace voxc::construct {

using uint32_t = __UINT32_TYPE__;
using uint64_t = __UINT64_TYPE__;

/// The lowest `count` bits, 1 to 64.
constexpr uint64_t ones(unsigned count) { return ~uint64_t{0} >> (64 - count); }

/// Voxel coordinates.
struct Voxel {
  int x = 0;
  int y = 0;
  int z = 0;
};

/// Most words of a node's masks: two sets for 64 children.
constexpr int kMaskWords = 4;

/// The value of voxels of which no more is kept than that they are there.
constexpr uint32_t kOccupied = 0xffffffff;

/// A node of a tree that has not found its place in the volume yet.
struct Node {
  enum Kind : uint32_t { Empty, Leaf, Inner };

  Kind kind = Empty;
  /// Leaf: the terminating integer. Inner: where the node is, or in a layout of siblings its first child.
  uint32_t value = 0;
  uint32_t masks[kMaskWords] = {}; ///< Inner: which children are not empty, and which of them are leaves.
  /// How many it has, where their values stand apart; else what slots of its kind tell a parent.
  uint32_t voxels = 0;

  /// A cell's terminating integer as a node: 0 is empty.
  static Node leaf(uint32_t value) { return {value == 0 ? Empty : Leaf, value}; }
};

/// A non-empty cell of a grid, counted from the grid's low corner.
struct PlacedCell {
  Voxel cell;
  uint32_t value;
  uint32_t voxels = 0; ///< How many there are below it, where their values stand apart.
};

/// What an aligned cube became that was built apart: a node of a tree, or cells of a grid.
struct Part {
  Node node;
  const PlacedCell *cells;
  uint64_t cell_count;
  uint64_t values; ///< How many values were put apart.
};

/// log2 of the side of the bricks in which voxels are read.
constexpr int kLog2Brick = 3;

/// An aligned cube of 8 voxels a side, in Morton order.
struct Brick {
  uint32_t voxels[512];
  /// Bit i % 64 of word i / 64 tells that voxel i is not empty.
  uint64_t filled[8];

  /// True if a voxel of the aligned 2^log2_count from `first` on is not empty.
  bool holds_any(unsigned first, int log2_count) const {
    if (log2_count <= 6)
      return filled_from(first, 1u << log2_count) != 0;
    uint64_t any = 0;
    for (const uint64_t word : filled)
      any |= word;
    return any != 0;
  }
  /// A bit for each of `count` voxels from `first` on that is not empty; 64 at most, all in one word.
  uint64_t filled_from(unsigned first, unsigned count) const {
    return filled[first / 64] >> first % 64 & ones(count);
  }
};

/// What the program that builds a volume offers to the code that arranges it.
struct Host {
  void *self;
  /// True only if the aligned cube of 2^log2_side voxels a side holds no voxel. Always true once building has
  /// failed.
  bool (*is_empty)(void *self, Voxel low, int log2_side);
  /// Reads the aligned cube of 8 voxels a side.
  void (*read_brick)(void *self, Voxel low, Brick *brick);
  /// Appends a node, or the records of siblings, to the volume; returns the offset of the first word.
  uint32_t (*append)(void *self, unsigned level, const uint32_t *words, uint64_t count);
  /// The same, but nodes that this level has been given before are not written again.
  uint32_t (*intern)(void *self, unsigned level, const uint32_t *words, uint64_t count);
  /// The same for the word of a leaf.
  uint32_t (*intern_leaf)(void *self, unsigned level, uint32_t value);
  /// Where the word of a leaf is that this level was given before; 0 if it was not.
  uint32_t (*find_leaf)(void *self, unsigned level, uint32_t value);
  /// Takes the value of the next voxel, of those that stand apart.
  void (*put_value)(void *self, uint32_t value);
  /// Tells that these words will soon be interned; and that no more are told of, for now. Both only make that
  /// faster.
  void (*announce)(void *self, unsigned level, const uint32_t *words, uint64_t count);
  void (*end_announcing)(void *self, unsigned level);
  /// Forgets which nodes and leaves a level has been given.
  void (*forget)(void *self, unsigned level);
  /// Zeroed memory for the one grid of a level that is being filled, and its return. Null once building has
  /// failed.
  uint32_t *(*allocate)(void *self, unsigned level, uint64_t count);
  void (*release)(void *self, unsigned level);
  /// Keeps the number and the value of a cell for the one hashed grid of a level that is being filled; gives
  /// all that were kept, two words each; forgets them.
  void (*keep)(void *self, unsigned level, uint32_t cell, uint32_t value);
  const uint32_t *(*kept)(void *self, unsigned level, uint64_t *count);
  void (*drop)(void *self, unsigned level);
  /// To be called during long work on a grid, with the words touched since: lets the program look after its
  /// memory.
  void (*pause)(void *self, uint64_t words);

  /// Cubes of 2^log2_part voxels a side were built apart; -1: none.
  int log2_part;
  void (*take_part)(void *self, Voxel low, Part *part);
  /// Hands over the result of building a part.
  void (*finish_node)(void *self, const Node *node);
  void (*finish_cell)(void *self, const PlacedCell *cell);
};

/// What an edit makes of an aligned cube.
enum class Effect : uint32_t {
  Keep,   ///< Nothing.
  Set,    ///< All its voxels become one value; 0: none is left.
  Change, ///< Something that only smaller cubes tell, or single voxels.
};

/// What the program that edits a volume offers beside: what the edit is, and what the volume was.
struct EditHost {
  void *self;
  /// `value`: what the voxels become, where it is `Set`.
  Effect (*effect)(void *self, Voxel low, int log2_side, uint32_t *value);
  /// What a voxel becomes.
  uint32_t (*voxel)(void *self, Voxel at, uint32_t old);
  /// The root of an old sub-volume of a tree; the children of an old inner node, in Morton order, all of
  /// which are empty before; the cells of an old grid, by their number, all of which are 0 before.
  void (*root)(void *self, unsigned level, uint32_t old, Node *root);
  void (*children)(void *self, unsigned level, const Node *node, Node *children);
  void (*read_cells)(void *self, unsigned level, uint32_t old, uint32_t *cells);
  /// The value of one cell of an old grid; and all of its cells that were not kept (`Host::keep`), to those
  /// that were, of which those of value 0 go.
  uint32_t (*cell)(void *self, unsigned level, uint32_t old, uint32_t cell);
  void (*keep_others)(void *self, unsigned level, uint32_t old);
  /// The words of an old grid to be changed: those of the volume, or a copy; zeros if `old` is 0. Null once
  /// the edit has failed.
  uint32_t *(*open)(void *self, unsigned level, uint32_t old, uint64_t count);
  /// Words of an open grid that are about to change.
  void (*touch)(void *self, unsigned level, const uint32_t *words, uint64_t count);
  /// Ends the changes of the open grid of a level; returns what leads to it. `shared`: a copy is interned.
  uint32_t (*close)(void *self, unsigned level, bool shared);
  void (*abandon)(void *self, unsigned level);
  /// A node, or all of a sub-volume, which is a node without kind, was replaced by a cube of one value.
  void (*replaced)(void *self, unsigned level, int layers, const Node *old, int log2_side, uint32_t value);
};

} // namespace voxc::construct
