// voxc_tree.h: construction of trees. A level is a struct of constants; its kind of slots writes the nodes,
// and its root ends a sub-volume.
#pragma once

#include "voxc_construct.h"

namespace voxc::construct {

/// What leads to a sub-volume of a root. One of a single cell is a leaf, whose word stands apart.
template <typename Level> struct ApartRoot {
  static uint32_t end(Build &build, const Node &root) {
    return root.kind == Node::Leaf ? build.intern_leaf(Level::NUMBER, root.value) : root.value;
  }
};

/// The same where a leaf stands in the slot that leads to it: the root is no leaf, if it is anything.
template <typename Level> struct InSlotRoot {
  static uint32_t end(Build &, const Node &root) { return root.value; }
};

/// The same of a root that gets a record of its own.
template <typename Level> struct RecordRoot {
  static uint32_t end(Build &build, const Node &root) {
    if (root.kind == Node::Empty)
      return 0;
    constexpr int kMasks = mask_words(Level::CHILDREN);
    uint32_t record[1 + kMasks] = {root.value};
    for (int i = 0; i < kMasks; ++i)
      record[1 + i] = root.masks[i];
    return build.append(Level::NUMBER, record, 1 + kMasks);
  }
};

/// The node, `layers` above the cells, with these children: equal leaves become one, but for the root, which
/// is a node.
template <typename Level> Node join(Build &build, const Children<Level::CHILDREN> &children, int layers) {
  if (layers < Level::LAYERS && children.are_equal_leaves()) {
    Node leaf = Node::leaf(children.values[0]);
    if constexpr (Level::RANKED)
      leaf.voxels = children.voxels[0] * Level::CHILDREN;
    return leaf;
  }
  return Level::Slots::write(build, children);
}

template <typename Level> struct Tree {
  static constexpr int kLog2Cell = Level::LOG2_CELL;

  /// Builds the sub-volume at `low`; returns what leads to it, 0 if it has no voxel.
  static uint32_t construct(Build &build, Voxel low) {
    if constexpr (Level::FORGETS)
      build.forget(Level::NUMBER);
    return Level::Root::end(build, node(build, low, Level::LAYERS));
  }

  /// Hands over the node over the aligned cube of 2^log2_side voxels a side at `low`, built apart.
  static void part(Build &build, Voxel low, int log2_side) {
    build.finish(node(build, low, (log2_side - Level::LOG2_CELL) / Level::BRANCH));
  }

private:
  /// The node, `layers` above the cells, whose low corner is `low`.
  static Node node(Build &build, Voxel low, int layers) {
    const int log2_side = Level::LOG2_CELL + layers * Level::BRANCH;
    if (build.is_empty(low, log2_side))
      return {};
    if constexpr (!Level::BRICKS)
      if (layers == 0)
        return cell(build, low);
    if (build.is_part(log2_side))
      return build.take_part(low).node;
    if constexpr (Level::BRICKS)
      if (log2_side <= kLog2Brick)
        return in_brick(build, low, layers);
    Children<Level::CHILDREN> children;
    for (unsigned i = 0; i < Level::CHILDREN; ++i)
      children.put(i, node(build, child_low(low, i, log2_side - Level::BRANCH), layers - 1));
    return join<Level>(build, children, layers);
  }

  static Node cell(Build &build, Voxel low) {
    const uint32_t before = build.values();
    Node cell = Node::leaf(Level::Cells::construct(build, low));
    if constexpr (Level::RANKED)
      cell.voxels = build.values() - before;
    return cell;
  }

  /// The same of cells that are voxels, of a node no larger than a brick.
  static Node in_brick(Build &build, Voxel low, int layers) {
    const Brick &brick = build.brick(low);
    if constexpr (Level::LOOKS_AHEAD)
      if (layers * Level::BRANCH == kLog2Brick)
        Level::Slots::look_ahead(build, brick);
    return brick_node(build, brick, brick_index(low), layers);
  }

  /// The node, `layers` above the voxels of a brick from `first` on.
  static Node brick_node(Build &build, const Brick &brick, unsigned first, int layers) {
    if (layers == 0) {
      if constexpr (Level::RANKED)
        return build.put_voxel(brick.voxels[first]);
      else
        return Node::leaf(brick.voxels[first]);
    }
    if (!brick.holds_any(first, 3 * Level::BRANCH * layers))
      return {};
    Children<Level::CHILDREN> children;
    if (!Level::RANKED && layers == 1)
      children.put_voxels(brick, first);
    else
      for (unsigned i = 0; i < Level::CHILDREN; ++i)
        children.put(i,
                     brick_node(build, brick, first + (i << 3 * Level::BRANCH * (layers - 1)), layers - 1));
    return join<Level>(build, children, layers);
  }
};

} // namespace voxc::construct
