// What octrees and DAGs share: they differ only in where a node keeps its masks and its children.
#pragma once

#include "Kinds.h"

namespace voxc {

/// Follows a cell down a tree. `Layout` says how nodes lie in words:
///   masks(words, node); child(words, node, rank): the child's offset; kLeafWords: words of a leaf.
template <typename Layout>
Lookup lookupTree(const WordReader &words, const Level &level, std::uint32_t offset, Int3 cell) {
  std::uint64_t node = offset;
  for (int height = static_cast<int>(level.parameter(ParameterRole::Side)); height > 0; --height) {
    const NodeMasks masks = Layout::masks(words, node);
    const int child = childIndex(cell, height);
    if (!masks.valid(child))
      return {0, height - 1};
    node = Layout::child(words, node, masks.rank(child));
    if (masks.leaf(child))
      return {words[node], height - 1};
  }
  return {words[node], 0};
}

/// Visits the nodes of a tree in Morton order and checks each before it is used.
template <typename Layout> class TreeWalk {
public:
  TreeWalk(WordReader &words, SubVolumeVisitor &visitor) : words_(words), visitor_(visitor) {}

  void root(const Level &level, std::uint32_t offset) {
    const Cube all = {{}, static_cast<int>(level.parameter(ParameterRole::Side))};
    if (all.log2Side == 0)
      leaf(offset, all);
    else
      inner(offset, all);
  }

private:
  void leaf(std::uint64_t node, Cube cube) {
    if (!words_.require(node, Layout::kLeafWords, "a leaf"))
      return;
    if (words_[node] == 0 || (Layout::kLeafWords == 2 && words_[node + 1] != 0))
      words_.fail("a leaf at word " + std::to_string(node) + " is empty or malformed");
    else
      visitor_.cells(cube, words_[node]);
  }

  void inner(std::uint64_t node, Cube cube) {
    if (visitor_.done() || !visitor_.enterNode(static_cast<std::uint32_t>(node), cube.log2Side) ||
        !Layout::requireNode(words_, node))
      return;
    const NodeMasks masks = Layout::masks(words_, node);
    checkMasks(words_, masks, cube.log2Side);
    for (int child = 0; child < 8; ++child) {
      if (!masks.valid(child))
        continue;
      const Cube at = {childLow(cube.low, child, cube.log2Side), cube.log2Side - 1};
      const std::uint64_t childNode = Layout::child(words_, node, masks.rank(child));
      if (masks.leaf(child))
        leaf(childNode, at);
      else if (at.log2Side > 0)
        inner(childNode, at);
    }
    visitor_.leaveNode();
  }

  WordReader &words_;
  SubVolumeVisitor &visitor_;
};

template <typename Layout>
void walkTree(WordReader &words, const Level &level, std::uint32_t offset, SubVolumeVisitor &visitor) {
  TreeWalk<Layout>(words, visitor).root(level, offset);
}

} // namespace voxc
