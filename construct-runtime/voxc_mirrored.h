// voxc_mirrored.h: nodes that are written once with all their reflections.
#pragma once

#include "voxc_construct.h"

namespace voxc::construct {

/// The bits of a reference that say where a node is; those above say by which reflection it is read.
constexpr unsigned kPlaceBits = 29;

template <typename Level> struct MirroredSlots {
  /// Writes a node, unless it or a reflection of it is written already. Its masks say which children are
  /// leaves, and that is all there is to say of them.
  static Node write(Build &build, const Children<Level::CHILDREN> &children) {
    if (children.filled == 0)
      return {};
    const Mirrored mirrored = mirror(children);
    Node node = children.parent();
    node.masks[0] |= mirrored.symmetries << kSymmetriesAt;
    node.voxels = mirrored.number();
    node.value = build.intern(Level::NUMBER, mirrored.node.words, mirrored.node.count);
    if (node.value != 0) // Else building has failed.
      node.value |= mirrored.reflection << kPlaceBits;
    return node;
  }

  /// Announces the nodes above the voxels of a brick before they are written, so that what they are compared
  /// with is near then.
  static void look_ahead(Build &build, const Brick &brick) {
    for (unsigned first = 0; first < 512; first += Level::CHILDREN) {
      if (brick.filled_from(first, Level::CHILDREN) == 0)
        continue;
      Children<Level::CHILDREN> children;
      children.put_voxels(brick, first);
      const Mirrored mirrored = mirror(children);
      build.announce(Level::NUMBER, mirrored.node.words, mirrored.node.count);
    }
    build.end_announcing(Level::NUMBER);
  }

private:
  /// Which reflections a node stays equal under stand, a bit for each, above its masks while it has not found
  /// its place.
  static constexpr unsigned kSymmetriesAt = 2 * Level::CHILDREN;

  /// A node's words, and by what its reflections are told apart: offsets differ from part to part of a
  /// volume, and so in place of a reference stand the number of what it leads to, which says what that is and
  /// not where, and how it is read.
  struct Reflected {
    uint32_t words[1 + Level::CHILDREN];
    uint32_t key[1 + 2 * Level::CHILDREN];
    unsigned count = 1; ///< Of the words.

    /// True if it comes before another in the order by which one of all is chosen.
    bool is_before(const Reflected &other) const {
      for (unsigned i = 0; i < 2 * count - 1; ++i)
        if (key[i] != other.key[i])
          return key[i] < other.key[i];
      return false;
    }
    bool equals(const Reflected &other) const {
      for (unsigned i = 0; i < count; ++i)
        if (words[i] != other.words[i])
          return false;
      return true;
    }
  };

  /// Of the eight reflections of a node, the one that comes first.
  struct Mirrored {
    Reflected node;
    unsigned reflection = 0; ///< By which it came about,
    uint32_t symmetries = 1; ///< and those that change nothing, a bit for each.

    /// A number of what it is.
    uint32_t number() const {
      uint32_t mixed = 0;
      for (unsigned i = 0; i < 2 * node.count - 1; ++i) {
        mixed = (mixed ^ node.key[i]) * 0x9e3779b1u;
        mixed ^= mixed >> 15;
      }
      return mixed;
    }
  };

  /// What leads to a node when all around it is reflected: of the reflections that come to the same, the
  /// least.
  static uint32_t reflected_reference(uint32_t reference, uint32_t symmetries, unsigned reflection) {
    const unsigned own = reference >> kPlaceBits ^ reflection;
    unsigned least = own;
    for (unsigned other = 1; other < 8; ++other)
      if ((symmetries >> other & 1) != 0 && (own ^ other) < least)
        least = own ^ other;
    return (reference & ((1u << kPlaceBits) - 1)) | least << kPlaceBits;
  }

  /// The node with these children, reflected. Where children count voxels in other levels, they have their
  /// numbers here.
  static Reflected reflect(const Children<Level::CHILDREN> &children, unsigned reflection) {
    Reflected node;
    node.words[0] = 0;
    for (unsigned place = 0; place < Level::CHILDREN; ++place) {
      const unsigned i = place ^ reflection;
      if ((children.filled >> i & 1) == 0)
        continue;
      node.words[0] |= 1u << place;
      if (children.is_leaf(i)) {
        node.words[0] |= 1u << (Level::CHILDREN + place);
        continue;
      }
      const uint32_t symmetries = children.masks[i][0] >> kSymmetriesAt;
      const uint32_t reference = reflected_reference(children.values[i], symmetries, reflection);
      node.key[2 * node.count - 1] = children.voxels[i];
      node.key[2 * node.count] = reference >> kPlaceBits;
      node.words[node.count++] = reference;
    }
    node.key[0] = node.words[0];
    return node;
  }

  static Mirrored mirror(const Children<Level::CHILDREN> &children) {
    const Reflected own = reflect(children, 0);
    Mirrored first = {own};
    for (unsigned reflection = 1; reflection < Level::CHILDREN; ++reflection) {
      const Reflected node = reflect(children, reflection);
      if (node.equals(own))
        first.symmetries |= 1u << reflection;
      if (!node.is_before(first.node))
        continue;
      first.node = node;
      first.reflection = reflection;
    }
    return first;
  }
};

} // namespace voxc::construct
