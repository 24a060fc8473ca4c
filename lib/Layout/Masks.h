// The masks at the head of a node: a bit for each child that is not empty and, where children may be leaves,
// such another set. Up to 16 children with leaves share one word; else each set is words of its own. A node
// of more than 64 children counts: each word of its mask is followed by how many children the words before it
// have; where neither slots nor ranks are to be found by it, the counts are left out.
#pragma once

#include "voxc/Layout/SlotKind.h"

#include <bit>
#include <cstdint>

namespace voxc {

/// Where the bits of a stratum's masks lie.
struct MaskShape {
  explicit MaskShape(const Stratum &stratum)
      : children(std::uint64_t{1} << stratum.log2Children()), hasLeaves(!stratum.isGrid()),
        sharesWord(hasLeaves && children <= 16), impliesLeaves(stratum.implied),
        counts(countsMaskWords(stratum)) {}

  std::uint64_t children;
  bool hasLeaves;
  bool sharesWord;    ///< The leaves' bits follow those of the children in the same word.
  bool impliesLeaves; ///< Leaves, and the cells of a grid, have no slots.
  bool counts;        ///< Each word is followed by a count.

  /// True if leaves have a set of words of their own: there are more children than one word has room for.
  bool hasTwoSets() const { return hasLeaves && !sharesWord; }
  /// Words of one set.
  std::uint64_t setWords() const { return (children + 31) / 32; }
  /// Words of all masks, counts included.
  std::uint64_t words() const { return sharesWord ? 1 : setWords() * (hasLeaves || counts ? 2 : 1); }
};

/// The masks of one node.
class Masks {
public:
  Masks(const WordReader &words, const MaskShape &shape, std::uint64_t at)
      : words_(words), shape_(shape), at_(at) {}

  bool exists(std::uint64_t child) const { return word(child / 32) >> child % 32 & 1; }
  bool isLeaf(std::uint64_t child) const {
    return shape_.hasLeaves && (leaves(child / 32) >> child % 32 & 1) != 0;
  }
  /// Slots before that of `child`.
  std::uint64_t rank(std::uint64_t child) const {
    return shape_.impliesLeaves ? shape_.hasLeaves ? sum(child, &Masks::slotted) : 0 : earlier(child);
  }
  /// Children before `child` that are not empty.
  std::uint64_t earlier(std::uint64_t child) const {
    if (!shape_.counts)
      return sum(child, &Masks::word);
    return words_[at_ + child / 32 * 2 + 1] + bits(word(child / 32) & lower(child));
  }
  /// Leaves before `child` of a node that may have some.
  std::uint64_t earlierLeaves(std::uint64_t child) const { return sum(child, &Masks::leaves); }
  /// A bit for each child of a node of 64 at most, and for each that is a leaf.
  std::uint64_t all() const { return few(&Masks::word); }
  std::uint64_t allLeaves() const { return shape_.hasLeaves ? few(&Masks::leaves) : 0; }
  /// Children that are not empty, as the masks' bits say.
  std::uint64_t count() const {
    std::uint64_t sum = 0;
    for (std::uint64_t i = 0; i < shape_.setWords(); ++i)
      sum += bits(word(i));
    return sum;
  }
  /// Children that have a slot.
  std::uint64_t slots() const {
    std::uint64_t sum = 0;
    for (std::uint64_t i = 0; i < shape_.setWords(); ++i)
      sum += bits(slotted(i));
    return sum;
  }
  /// True if no child of the aligned group of eight around this one exists.
  bool isGroupEmpty(std::uint64_t child) const {
    return (word(child / 32) >> (child % 32 & ~7u) & 0xff) == 0;
  }

  /// Notes what no builder writes: bits of no meaning, leaves that are empty, wrong counts, no child at all,
  /// or, in the lowest layer, children that are no leaves.
  bool check(WordReader &words, bool lowest) const;

private:
  static std::uint64_t bits(std::uint32_t word) { return static_cast<std::uint64_t>(std::popcount(word)); }
  /// The bits of children before `child` in its word.
  static std::uint32_t lower(std::uint64_t child) { return (1u << child % 32) - 1; }

  /// The bits before that of `child` of the set whose word i a member gives.
  std::uint64_t sum(std::uint64_t child, std::uint32_t (Masks::*set)(std::uint64_t) const) const {
    std::uint64_t sum = bits((this->*set)(child / 32) & lower(child));
    for (std::uint64_t i = 0; i < child / 32; ++i)
      sum += bits((this->*set)(i));
    return sum;
  }

  std::uint64_t few(std::uint32_t (Masks::*set)(std::uint64_t) const) const {
    const std::uint64_t first = (this->*set)(0);
    return shape_.children > 32 ? first | std::uint64_t{(this->*set)(1)} << 32 : first;
  }

  /// Word i of the set of children, without what else it holds.
  std::uint32_t word(std::uint64_t i) const {
    const std::uint32_t whole = words_[at_ + (shape_.counts ? 2 * i : i)];
    return shape_.children < 32 ? whole & ((1u << shape_.children) - 1) : whole;
  }
  /// The same of the set of leaves.
  std::uint32_t leaves(std::uint64_t i) const {
    return shape_.sharesWord ? words_[at_] >> shape_.children : words_[at_ + shape_.setWords() + i];
  }
  /// Those of word i that have slots.
  std::uint32_t slotted(std::uint64_t i) const {
    if (!shape_.impliesLeaves)
      return word(i);
    return shape_.hasLeaves ? word(i) & ~leaves(i) : 0;
  }

  const WordReader &words_;
  const MaskShape &shape_;
  std::uint64_t at_;
};

} // namespace voxc
