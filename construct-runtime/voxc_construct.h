// voxc_construct.h: what generated construction code stands on. Freestanding: no library, no other header.
#pragma once

namespace voxc::construct {

using uint32_t = __UINT32_TYPE__;
using uint64_t = __UINT64_TYPE__;

/// Voxel coordinates.
struct Voxel {
  int x = 0;
  int y = 0;
  int z = 0;
};

/// What the program that builds a volume offers to the code that arranges it.
struct Host {
  void *self;
  /// True only if the aligned cube of 2^log2_side voxels a side holds no voxel. Always true once building has
  /// failed.
  bool (*is_empty)(void *self, Voxel low, int log2_side);
  /// Writes the 512 voxels of the aligned cube of 8 voxels a side, in Morton order.
  void (*read_brick)(void *self, Voxel low, uint32_t *voxels);
  /// Appends words to the volume; returns the offset of the first.
  uint32_t (*append)(void *self, const uint32_t *words, uint64_t count);
  /// The same, but words that this level has been given before are not written again.
  uint32_t (*intern)(void *self, unsigned level, const uint32_t *words, uint64_t count);
  /// Forgets which words a level has been given.
  void (*forget)(void *self, unsigned level);
  /// Zeroed memory for a grid while it is filled, and its return. Null once building has failed.
  uint32_t *(*allocate)(void *self, uint64_t count);
  void (*release)(void *self, uint32_t *words);
};

/// Spreads the low three bits of a coordinate to every third bit.
constexpr unsigned spread3(int i) { return static_cast<unsigned>((i & 1) | (i & 2) << 2 | (i & 4) << 4); }

/// One run over the voxels of a source, in Morton order.
class Build {
public:
  explicit Build(const Host &host) : host_(host) {}

  /// True if the aligned cube of 2^log2_side voxels a side holds no voxel; may be false for an empty one.
  bool is_empty(Voxel low, int log2_side) {
    if (log2_side >= kLog2Brick)
      return host_.is_empty(host_.self, low, log2_side);
    if (!load(low))
      return true;
    const uint32_t *voxels = brick_ + index(low);
    for (int i = 0; i < 1 << (3 * log2_side); ++i)
      if (voxels[i] != 0)
        return false;
    return true;
  }

  uint32_t voxel(Voxel at) { return load(at) ? brick_[index(at)] : 0; }

  uint32_t append(const uint32_t *words, uint64_t count) { return host_.append(host_.self, words, count); }
  uint32_t intern(unsigned level, const uint32_t *words, uint64_t count) {
    return host_.intern(host_.self, level, words, count);
  }
  void forget(unsigned level) { host_.forget(host_.self, level); }
  uint32_t *allocate(uint64_t count) { return host_.allocate(host_.self, count); }
  void release(uint32_t *words) { host_.release(host_.self, words); }

private:
  static constexpr int kLog2Brick = 3;

  static unsigned index(Voxel at) { return spread3(at.x) | spread3(at.y) << 1 | spread3(at.z) << 2; }

  /// Makes `brick_` the brick around a voxel; false if it is known to be empty.
  bool load(Voxel at) {
    const Voxel low = {at.x & -8, at.y & -8, at.z & -8};
    if (!loaded_ || low.x != low_.x || low.y != low_.y || low.z != low_.z) {
      loaded_ = true;
      low_ = low;
      holds_voxels_ = !host_.is_empty(host_.self, low, kLog2Brick);
      if (holds_voxels_)
        host_.read_brick(host_.self, low, brick_);
    }
    return holds_voxels_;
  }

  const Host &host_;
  Voxel low_;
  bool loaded_ = false;
  bool holds_voxels_ = false;
  uint32_t brick_[512];
};

/// log2 of the cells of a grid along each axis.
struct GridSize {
  int x;
  int y;
  int z;

  constexpr uint64_t cells() const { return uint64_t{1} << (x + y + z); }
  constexpr int longest() const { return x > y ? (x > z ? x : z) : (y > z ? y : z); }
  constexpr bool excludes(Voxel cell) const { return (cell.x >> x | cell.y >> y | cell.z >> z) != 0; }
};

/// A cell of a grid: its index, x fastest, then y, then z, and the low corner of its voxels.
struct GridCell {
  uint64_t index;
  Voxel low;
};

/// The low corner of child i = x + 2y + 4z of a cube whose children are 2^log2_side a side.
constexpr Voxel child_low(Voxel low, int i, int log2_side) {
  return {low.x + ((i & 1) << log2_side), low.y + ((i >> 1 & 1) << log2_side),
          low.z + ((i >> 2 & 1) << log2_side)};
}

/// Visits the cells of a grid in Morton order of its bounding cube, as far as they may hold voxels: cells
/// outside a grid that is no cube are skipped a whole aligned cube at a time, and so are empty ones. `cell`
/// is the low corner, in cells, of the 2^height cells a side to visit.
template <typename Visit>
void for_each_cell(Build &build, Voxel low, GridSize size, int log2_cell, Voxel cell, int height,
                   Visit &visit) {
  const Voxel corner = {low.x + (cell.x << log2_cell), low.y + (cell.y << log2_cell),
                        low.z + (cell.z << log2_cell)};
  if (size.excludes(cell) || build.is_empty(corner, height + log2_cell))
    return;
  if (height == 0) {
    const auto row = static_cast<uint64_t>(cell.y) + (static_cast<uint64_t>(cell.z) << size.y);
    visit(GridCell{static_cast<uint64_t>(cell.x) + (row << size.x), corner});
    return;
  }
  for (int i = 0; i < 8; ++i)
    for_each_cell(build, low, size, log2_cell, child_low(cell, i, height - 1), height - 1, visit);
}

/// A node of a tree that has not found its place in the volume yet.
struct Node {
  enum Kind { Empty, Leaf, Inner };

  Kind kind = Empty;
  uint32_t value =
      0; ///< Leaf: the terminating integer. Inner: the node's offset (G), or its first child's (S).
  uint32_t masks = 0; ///< Inner: bit i says that child i is not empty, bit 8 + i that it is a leaf.

  /// A cell's terminating integer as a node: 0 is empty.
  static Node leaf(uint32_t value) { return {value == 0 ? Empty : Leaf, value, 0}; }
};

/// True if eight children are leaves of one value, so that their parent is that leaf.
inline bool are_equal_leaves(const Node (&children)[8]) {
  for (const Node &child : children)
    if (child.kind != Node::Leaf || child.value != children[0].value)
      return false;
  return true;
}

/// The masks of a node with these children; 0 if all are empty.
inline uint32_t masks_of(const Node (&children)[8]) {
  uint32_t masks = 0;
  for (int i = 0; i < 8; ++i) {
    if (children[i].kind != Node::Empty)
      masks |= 1u << i;
    if (children[i].kind == Node::Leaf)
      masks |= 1u << (8 + i);
  }
  return masks;
}

} // namespace voxc::construct
