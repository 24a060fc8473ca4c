// voxc_edit.h: what generated code stands on that edits a volume: what becomes of cubes, what nodes and grids
// were before, the cells that change. Freestanding: no library.
#pragma once

#include "voxc_grid.h"

inline void *operator new(__SIZE_TYPE__, void *memory) noexcept { return memory; }

namespace voxc::construct {

/// A run of edits of one volume. Words are only added, so that what was found stays right from one edit to
/// the next.
class Edit : public Build {
public:
  Edit(const Host &host, const EditHost &edits) : Build(host), edits_(edits) {}

  /// What becomes of the aligned cube of 2^log2_side voxels a side.
  Effect effect(Voxel low, int log2_side, uint32_t &value) {
    return edits_.effect(edits_.self, low, log2_side, &value);
  }
  bool keeps(Voxel low, int log2_side) {
    uint32_t value = 0;
    return effect(low, log2_side, value) == Effect::Keep;
  }
  uint32_t voxel(Voxel at, uint32_t old) { return edits_.voxel(edits_.self, at, old); }

  Node root(unsigned level, uint32_t old) {
    Node root;
    if (old != 0)
      edits_.root(edits_.self, level, old, &root);
    return root;
  }
  /// The children of an old node: those of a leaf are leaves, and those of an empty one are empty.
  void children(unsigned level, const Node &node, Node *children, unsigned count) {
    if (node.kind == Node::Inner)
      edits_.children(edits_.self, level, &node, children);
    for (unsigned i = 0; node.kind == Node::Leaf && i < count; ++i)
      children[i] = node;
  }
  void read_cells(unsigned level, uint32_t old, uint32_t *cells) {
    if (old != 0)
      edits_.read_cells(edits_.self, level, old, cells);
  }
  uint32_t cell(unsigned level, uint32_t old, uint32_t cell) {
    return old == 0 ? 0 : edits_.cell(edits_.self, level, old, cell);
  }
  void keep_others(unsigned level, uint32_t old) { edits_.keep_others(edits_.self, level, old); }
  uint32_t *open(unsigned level, uint32_t old, uint64_t count) {
    return edits_.open(edits_.self, level, old, count);
  }
  void touch(unsigned level, const uint32_t *words, uint64_t count) {
    edits_.touch(edits_.self, level, words, count);
  }
  uint32_t close(unsigned level, bool shared) { return edits_.close(edits_.self, level, shared); }
  /// The same of changes that come to nothing.
  void abandon(unsigned level) { edits_.abandon(edits_.self, level); }

  /// A node, so many layers above the cells, was replaced by a cube of one value; all of a sub-volume was.
  void replace(unsigned level, int layers, const Node &old, int log2_side, uint32_t value) {
    edits_.replaced(edits_.self, level, layers, &old, log2_side, value);
  }
  void replace(unsigned level, uint32_t old, int log2_side, uint32_t value) {
    replace(level, 0, {Node::Empty, old}, log2_side, value);
  }

  /// What leads to a sub-volume of voxels of one value, which `fill` makes where it is not known.
  uint32_t filled(unsigned level, uint32_t value, uint32_t (*fill)(Edit &edit, uint32_t value)) {
    if (value == 0)
      return 0;
    KnownFill &known = fills_[(value * 0x9e3779b1u + level) >> (32 - kLog2Fills)];
    if (known.level != level || known.value != value) {
      const uint32_t made = fill(*this, value); // Which makes those of lower levels, and may take this place.
      known = {level, value, made};
    }
    return known.filled;
  }

private:
  struct KnownFill {
    unsigned level = 0;
    uint32_t value = 0;
    uint32_t filled = 0;
  };
  static constexpr unsigned kLog2Fills = 6;

  const EditHost &edits_;
  KnownFill fills_[1u << kLog2Fills];
};

/// What cells of the last level hold: as a level below.
struct EditedVoxels {
  static uint32_t edit(Edit &edit, uint32_t old, Voxel at) { return edit.voxel(at, old); }
  static uint32_t filled(Edit &, uint32_t value) { return value; }
};

/// True if two nodes are one, so that nothing above them changes.
inline bool are_same(const Node &node, const Node &other) {
  return node.kind == other.kind && node.value == other.value;
}

/// Visits the cells of a grid that may change, with their corners, in Morton order of its bounding cube.
template <GridShape kShape, typename Visit>
void for_each_edited_cell(Edit &edit, Voxel low, Voxel cell, int height, Visit &visit) {
  constexpr int kLog2Cell = kShape.log2_cell;
  if (kShape.excludes(cell))
    return;
  const Voxel corner = {low.x + (cell.x << kLog2Cell), low.y + (cell.y << kLog2Cell),
                        low.z + (cell.z << kLog2Cell)};
  if (height == 0)
    return visit(cell, corner);
  if (!edit.keeps(corner, height + kLog2Cell))
    for (unsigned i = 0; i < 8; ++i)
      for_each_edited_cell<kShape>(edit, low, child_low(cell, i, height - 1), height - 1, visit);
}

/// A box of cells, both ends of which belong to it; it begins as none.
struct CellBox {
  Voxel first = {0x7fffffff, 0x7fffffff, 0x7fffffff};
  Voxel last = {-1, -1, -1};

  bool is_empty() const { return last.x < 0; }
  void add(Voxel cell) {
    first = {least(first.x, cell.x), least(first.y, cell.y), least(first.z, cell.z)};
    last = {most(last.x, cell.x), most(last.y, cell.y), most(last.z, cell.z)};
  }
  /// The box with so many cells more before it and behind it, as far as the grid goes.
  template <GridShape kShape> CellBox grown(Voxel before, Voxel behind) const {
    return {{most(first.x - before.x, 0), most(first.y - before.y, 0), most(first.z - before.z, 0)},
            {least(last.x + behind.x, (1 << kShape.x) - 1), least(last.y + behind.y, (1 << kShape.y) - 1),
             least(last.z + behind.z, (1 << kShape.z) - 1)}};
  }

private:
  static constexpr int least(int a, int b) { return a < b ? a : b; }
  static constexpr int most(int a, int b) { return a < b ? b : a; }
};

/// Visits the cells of a box row by row; along each axis by rising coordinates, or by falling ones.
template <typename Visit>
void for_each_in_order(const CellBox &box, const bool (&rises)[3], const Visit &visit) {
  const auto at = [](int first, int last, bool rises, int i) { return rises ? first + i : last - i; };
  for (int z = 0; z <= box.last.z - box.first.z; ++z)
    for (int y = 0; y <= box.last.y - box.first.y; ++y)
      for (int x = 0; x <= box.last.x - box.first.x; ++x)
        visit(Voxel{at(box.first.x, box.last.x, rises[0], x), at(box.first.y, box.last.y, rises[1], y),
                    at(box.first.z, box.last.z, rises[2], z)});
}

/// Tells of the slots of a box of cells that they are about to change.
template <GridShape kShape>
void touch_rows(Edit &edit, unsigned level, const uint32_t *grid, uint64_t slot_words, const CellBox &box) {
  const auto cells = static_cast<uint64_t>(box.last.x - box.first.x + 1);
  for (int z = box.first.z; z <= box.last.z; ++z)
    for (int y = box.first.y; y <= box.last.y; ++y)
      edit.touch(level, grid + slot_words * kShape.index({box.first.x, y, z}), slot_words * cells);
}

} // namespace voxc::construct
