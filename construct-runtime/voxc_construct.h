// voxc_construct.h: what generated construction code stands on: a run over the voxels, and the children of
// nodes. Freestanding: no library.
#pragma once

#include "voxc_host.h"

namespace voxc::construct {

/// Takes the lowest bit out of `bits`, which are not 0; returns its number.
inline unsigned take_bit(uint64_t &bits) {
  const auto bit = static_cast<unsigned>(__builtin_ctzll(bits));
  bits &= bits - 1;
  return bit;
}

/// Spreads the low three bits of a coordinate to every third bit.
constexpr unsigned spread3(int i) { return static_cast<unsigned>((i & 1) | (i & 2) << 2 | (i & 4) << 4); }

/// The place of a voxel within its brick, in Morton order, and the voxel at a place.
constexpr unsigned brick_index(Voxel at) { return spread3(at.x) | spread3(at.y) << 1 | spread3(at.z) << 2; }
constexpr Voxel brick_voxel(unsigned index) {
  const auto gather = [](unsigned i) { return static_cast<int>((i & 1) | (i >> 2 & 2) | (i >> 4 & 4)); };
  return {gather(index), gather(index >> 1), gather(index >> 2)};
}

/// One run over the voxels of a source, in Morton order.
class Build {
public:
  explicit Build(const Host &host) : host_(host) {}

  /// True if the aligned cube of 2^log2_side voxels a side holds no voxel; may be false for an empty one.
  bool is_empty(Voxel low, int log2_side) {
    return log2_side >= kLog2Brick || is_part(log2_side)
               ? host_.is_empty(host_.self, low, log2_side)
               : !brick(low).holds_any(brick_index(low), 3 * log2_side);
  }

  /// The brick around `at`.
  const Brick &brick(Voxel at) {
    const Voxel low = {at.x & -8, at.y & -8, at.z & -8};
    if (!loaded_ || low.x != low_.x || low.y != low_.y || low.z != low_.z) {
      host_.read_brick(host_.self, low, &brick_);
      low_ = low;
      loaded_ = true;
    }
    return brick_;
  }

  uint32_t append(unsigned level, const uint32_t *words, uint64_t count) {
    return host_.append(host_.self, level, words, count);
  }
  uint32_t intern(unsigned level, const uint32_t *words, uint64_t count) {
    return host_.intern(host_.self, level, words, count);
  }
  /// The same for the word of a leaf: those that came last are remembered here.
  uint32_t intern_leaf(unsigned level, uint32_t value) {
    KnownLeaf &known = leaf_at(value);
    if (!is_known(known, level, value))
      known = {generation_, level, value, host_.intern_leaf(host_.self, level, value)};
    return known.offset;
  }
  /// Where the word of a leaf is that this level was given before; 0 if it was not.
  uint32_t find_leaf(unsigned level, uint32_t value) {
    KnownLeaf &known = leaf_at(value);
    if (!is_known(known, level, value))
      known = {generation_, level, value, host_.find_leaf(host_.self, level, value)};
    return known.offset;
  }
  void announce(unsigned level, const uint32_t *words, uint64_t count) {
    host_.announce(host_.self, level, words, count);
  }
  void end_announcing(unsigned level) { host_.end_announcing(host_.self, level); }
  /// Puts the value of the next voxel apart.
  void put_value(uint32_t value) {
    host_.put_value(host_.self, value);
    ++values_;
  }
  /// The same for a voxel that may be empty: what is left of it is that it is there.
  Node put_voxel(uint32_t value) {
    if (value == 0)
      return {};
    put_value(value);
    return {Node::Leaf, kOccupied, {}, 1};
  }
  /// How many values were put apart: that of the next voxel has this rank.
  uint32_t values() const { return values_; }

  void forget(unsigned level) {
    host_.forget(host_.self, level);
    if (++generation_ != 0)
      return;
    for (KnownLeaf &known : leaves_)
      known = {};
    generation_ = 1;
  }
  uint32_t *allocate(unsigned level, uint64_t count) { return host_.allocate(host_.self, level, count); }
  void release(unsigned level) { host_.release(host_.self, level); }
  void keep(unsigned level, uint32_t cell, uint32_t value) { host_.keep(host_.self, level, cell, value); }
  const uint32_t *kept(unsigned level, uint64_t &count) { return host_.kept(host_.self, level, &count); }
  void drop(unsigned level) { host_.drop(host_.self, level); }
  void pause(uint64_t words) { host_.pause(host_.self, words); }

  /// True if cubes of this size were built apart.
  bool is_part(int log2_side) const { return log2_side == host_.log2_part; }
  Part take_part(Voxel low) {
    Part part = {};
    host_.take_part(host_.self, low, &part);
    values_ += static_cast<uint32_t>(part.values);
    return part;
  }
  void finish(const Node &node) { host_.finish_node(host_.self, &node); }
  void finish(const PlacedCell &cell) { host_.finish_cell(host_.self, &cell); }

private:
  struct KnownLeaf {
    uint32_t generation = 0; ///< That of the build, if something is known here.
    unsigned level = 0;
    uint32_t value = 0;
    uint32_t offset = 0; ///< 0: it was not written when it was looked for.
  };
  static constexpr unsigned kLog2Leaves = 12;

  KnownLeaf &leaf_at(uint32_t value) { return leaves_[(value * 0x9e3779b1u) >> (32 - kLog2Leaves)]; }
  bool is_known(const KnownLeaf &known, unsigned level, uint32_t value) const {
    return known.generation == generation_ && known.level == level && known.value == value &&
           known.offset != 0;
  }

  const Host &host_;
  Voxel low_;
  bool loaded_ = false;
  Brick brick_;
  uint32_t values_ = 0;
  uint32_t generation_ = 1; ///< Another one after anything was forgotten.
  KnownLeaf leaves_[1u << kLog2Leaves];
};

/// The low corner of child i, in Morton order, of a cube whose children are 2^log2_side a side.
constexpr Voxel child_low(Voxel low, unsigned i, int log2_side) {
  const Voxel place = brick_voxel(i);
  return {low.x + (place.x << log2_side), low.y + (place.y << log2_side), low.z + (place.z << log2_side)};
}

/// What cells of the last level hold: as a level below.
struct Voxels {
  static uint32_t construct(Build &build, Voxel at) { return build.brick(at).voxels[brick_index(at)]; }
};

/// All levels of a volume, from the first on.
template <typename First, typename... Below> struct Levels {
  static uint32_t construct(Build &build) { return First::construct(build, {}); }

  /// Builds a cube apart: it belongs to the highest level with smaller cells.
  static void part(Build &build, Voxel low, int log2_side) {
    if constexpr (sizeof...(Below) > 0)
      if (log2_side <= First::kLog2Cell)
        return Levels<Below...>::part(build, low, log2_side);
    First::part(build, low, log2_side);
  }
};

/// Words of the masks of a node with so many children: both sets share one word, or have words of their own.
constexpr int mask_words(int children) { return 2 * children <= 32 ? 1 : children / 16; }

/// The children of a node that is about to be written. The arrays hold what is known of those that are not
/// empty.
template <int kChildren> struct Children {
  uint64_t filled = 0; ///< Bit i: child i is not empty.
  uint64_t leaves = 0; ///< Bit i: it is a leaf.
  uint32_t values[kChildren];
  uint32_t masks[kChildren][mask_words(kChildren)]; ///< Of inner ones.
  uint32_t voxels[kChildren];                       ///< Where values stand apart.

  void put(unsigned i, const Node &child) {
    if (child.kind == Node::Empty)
      return;
    filled |= uint64_t{1} << i;
    leaves |= uint64_t{child.kind == Node::Leaf} << i;
    values[i] = child.value;
    for (int word = 0; word < mask_words(kChildren); ++word)
      masks[i][word] = child.masks[word];
    voxels[i] = child.voxels;
  }

  /// Children that are voxels from `first` on.
  void put_voxels(const Brick &brick, unsigned first) {
    filled = leaves = brick.filled_from(first, kChildren);
    for (unsigned i = 0; i < kChildren; ++i)
      values[i] = brick.voxels[first + i];
  }

  bool is_leaf(unsigned i) const { return (leaves >> i & 1) != 0; }
  /// True if all are leaves of one value, so that their parent is that leaf.
  bool are_equal_leaves() const {
    if (leaves != ones(kChildren))
      return false;
    for (const uint32_t value : values)
      if (value != values[0])
        return false;
    return true;
  }

  /// Their masks as those of an inner node: the bits of the filled, then those of the leaves.
  Node parent() const {
    Node node = {Node::Inner};
    if constexpr (mask_words(kChildren) == 1)
      node.masks[0] = static_cast<uint32_t>(filled | leaves << kChildren);
    else
      for (unsigned i = 0; i < 2; ++i) {
        node.masks[i] = static_cast<uint32_t>(filled >> 32 * i);
        node.masks[2 + i] = static_cast<uint32_t>(leaves >> 32 * i);
      }
    return node;
  }
};

} // namespace voxc::construct
