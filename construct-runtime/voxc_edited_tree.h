// voxc_edited_tree.h: edits of trees: changed nodes are written anew, up to the root.
#pragma once

#include "voxc_edited.h"
#include "voxc_tree.h"

namespace voxc::construct {

template <typename Level> struct EditedTree {
  static uint32_t change(Edit &edit, uint32_t old, Voxel low) {
    const Node root = edit.root(Level::NUMBER, old);
    const Node changed = change_node(edit, root, low, Level::LAYERS);
    return are_same(root, changed) ? old : Level::Root::end(edit, changed);
  }

  /// A sub-volume of voxels of one value: its root is a node of leaves.
  static uint32_t fill(Edit &edit, uint32_t value) {
    const Node leaf = Node::leaf(Level::Cells::filled(edit, value));
    if (Level::LAYERS == 0)
      return Level::Root::end(edit, leaf);
    Children<Level::CHILDREN> children;
    for (unsigned i = 0; i < Level::CHILDREN; ++i)
      children.put(i, leaf);
    return Level::Root::end(edit, join<Level>(edit, children, Level::LAYERS));
  }

private:
  /// The node, `layers` above the cells, whose low corner is `low`, when its children are edited. `old` is
  /// what it was.
  static Node change_node(Edit &edit, const Node &old, Voxel low, int layers) {
    if (layers == 0) // Of a sub-volume of one cell.
      return Node::leaf(Level::Cells::edit(edit, old.value, low));
    const int log2_child = Level::LOG2_CELL + (layers - 1) * Level::BRANCH;
    Node before[Level::CHILDREN];
    edit.children(Level::NUMBER, old, before, Level::CHILDREN);
    Children<Level::CHILDREN> children;
    bool differs = false;
    for (unsigned i = 0; i < Level::CHILDREN; ++i) {
      const Node child = edit_node(edit, before[i], child_low(low, i, log2_child), layers - 1);
      differs |= !are_same(child, before[i]);
      children.put(i, child);
    }
    return differs ? join<Level>(edit, children, layers) : old;
  }

  /// The same of any node. That of the sub-volume as a whole is edited already.
  static Node edit_node(Edit &edit, const Node &old, Voxel low, int layers) {
    if (layers == 0)
      return Node::leaf(Level::Cells::edit(edit, old.value, low));
    const int log2_side = Level::LOG2_CELL + layers * Level::BRANCH;
    uint32_t value = 0;
    switch (edit.effect(low, log2_side, value)) {
    case Effect::Keep:
      return old;
    case Effect::Set:
      edit.replace(Level::NUMBER, layers, old, log2_side, value);
      return Node::leaf(Level::Cells::filled(edit, value));
    case Effect::Change:
      break;
    }
    return change_node(edit, old, low, layers);
  }
};

} // namespace voxc::construct
