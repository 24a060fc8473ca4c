// voxc_siblings.h: a record for each child that is not empty, those of one node next to each other.
#pragma once

#include "voxc_construct.h"

namespace voxc::construct {

template <typename Level> struct SiblingSlots {
  /// Writes the children that are not empty as one block; the node itself joins the block of its parent.
  static Node write(Build &build, const Children<Level::CHILDREN> &children) {
    constexpr int kMasks = mask_words(Level::CHILDREN);
    if (children.filled == 0)
      return {};
    Node node = children.parent();
    uint32_t block[(1 + kMasks) * Level::CHILDREN];
    uint64_t count = 0;
    for (uint64_t filled = children.filled; filled != 0;) {
      const unsigned i = take_bit(filled);
      block[count++] = children.values[i];
      for (int word = 0; word < kMasks; ++word)
        block[count++] = children.is_leaf(i) ? 0 : children.masks[i][word];
    }
    node.value = build.append(Level::NUMBER, block, count);
    return node;
  }
};

} // namespace voxc::construct
