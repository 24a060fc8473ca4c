// voxc_packed.h: nodes of masks, and a slot behind them for each child that is not empty.
#pragma once

#include "voxc_construct.h"

namespace voxc::construct {

/// Where levels count voxels, behind each slot stands how many the slots up to this one have.
template <typename Level> struct PackedSlots {
  /// Writes a node, unless it is written already. Its masks say which children are leaves, whose values stand
  /// in slots, or each in a word of its own that is written before the node, or are known without any.
  static Node write(Build &build, const Children<Level::CHILDREN> &children) {
    if (children.filled == 0)
      return {};
    uint32_t words[kMostWords];
    const auto leaf_of = [&](uint32_t value) { return build.intern_leaf(Level::NUMBER, value); };
    const uint64_t count = fill(children, words, leaf_of);
    Node node = children.parent();
    if constexpr (Level::RANKED)
      for (uint64_t filled = children.filled; filled != 0;)
        node.voxels += children.voxels[take_bit(filled)];
    node.value = build.intern(Level::NUMBER, words, count);
    return node;
  }

  /// Announces the nodes above the voxels of a brick before they are written, so that what they are compared
  /// with is near then. Nodes with a leaf that is not written yet are left out.
  static void look_ahead(Build &build, const Brick &brick) {
    uint32_t words[kMostWords];
    for (unsigned first = 0; first < 512; first += Level::CHILDREN) {
      if (brick.filled_from(first, Level::CHILDREN) == 0)
        continue;
      Children<Level::CHILDREN> children;
      children.put_voxels(brick, first);
      const auto leaf_of = [&](uint32_t value) { return build.find_leaf(Level::NUMBER, value); };
      if (const uint64_t count = fill(children, words, leaf_of))
        build.announce(Level::NUMBER, words, count);
    }
    build.end_announcing(Level::NUMBER);
  }

private:
  static constexpr uint64_t kMostWords = mask_words(Level::CHILDREN) + Level::SLOT_WORDS * Level::CHILDREN;

  /// Fills in the words of a node with these children and returns how many. `leaf_of` finds the word of a
  /// leaf, where leaves have words; where it gives 0, of a leaf that is not written yet, there are no words.
  template <typename LeafOf>
  static uint64_t fill(const Children<Level::CHILDREN> &children, uint32_t *words, const LeafOf &leaf_of) {
    const Node node = children.parent();
    uint64_t count = 0;
    for (; count < mask_words(Level::CHILDREN); ++count)
      words[count] = node.masks[count];
    uint32_t voxels = 0;
    for (uint64_t slots = Level::IMPLIED ? children.filled & ~children.leaves : children.filled;
         slots != 0;) {
      const unsigned i = take_bit(slots);
      words[count] = children.values[i];
      if constexpr (Level::HAS_LEAF_WORDS)
        if (children.is_leaf(i) && (words[count] = leaf_of(children.values[i])) == 0)
          return 0;
      ++count;
      voxels += Level::RANKED ? children.voxels[i] : 0;
      if constexpr (Level::RANKED)
        words[count++] = voxels;
    }
    return count;
  }
};

} // namespace voxc::construct
