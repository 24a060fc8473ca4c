// Strata: how the words of a volume lie, as data. A level of a format lowers to a stratum; whatever reads,
// checks, moves, writes or traces words is driven by this record, and nothing else knows a layout.
#pragma once

#include "voxc/Support/EnumText.h"
#include "voxc/Support/Geometry.h"

#include <cstdint>
#include <string>

namespace voxc {

struct SlotKind;

/// Where something begins in the words of a volume, counted in words or, past 2^32 of them, in granules
/// (`Layout::log2Granule`). 0 leads nowhere.
using Ref = std::uint32_t;

/// Words of a sub-volume that stands in an array: the masks of a grid of 4 x 4 x 4 voxels.
inline constexpr std::uint64_t kIndexedWords = 2;

/// log2 of the most cells of a grid whose slots are numbers: kernels count the bits of a run of them in a
/// word.
inline constexpr int kMaxLog2IndexedCells = 26;

/// The most words that references can reach, if they count words.
inline constexpr std::uint64_t kMaxWords = std::uint64_t{1} << 32;

/// log2 of the most words of a granule.
inline constexpr int kMaxLog2Granule = 8;

/// Where the value of a cell lies.
enum class Cells {
  Inline, ///< In the slot of the node itself: a grid.
  Word,   ///< In a word of its own, which the slot of a leaf refers to, so that equal ones are shared.
  Slot,   ///< In the slot of a leaf.
  Record, ///< In the first word of the child's record, whose masks are 0.
};

/// What an empty cell tells of the cells around it.
enum class Skip {
  None,
  L1,     ///< The L1 distance to the nearest cell of the sub-volume that is not empty, `reach` at most.
  Octant, ///< For each octant of directions, how many cells a side the largest empty cube has that begins in
          ///< the cell and goes that way, `reach` at most: eight fields in one word, that of the octant in
          ///< which x, y and z rise as bits 0, 1 and 2 say at its number. A cube may leave the volume, and no
          ///< other sub-volume.
};

/// Which slots are empty. Where it is not `Zero`, the rest of an empty slot holds its distance.
enum class Empty {
  Zero,   ///< Those of 0. A distance stands in a second word of the slot.
  Tagged, ///< Those with a tag, and references have fewer bits: 31, and the highest bit is the tag; beside
          ///< octants 28, above a field of 0.
  Transparent, ///< Those whose alpha, the highest byte, is 0: no voxel of the volume is.
};

/// Which equal blocks are written once.
enum class Sharing {
  None,
  SubVolume, ///< Those of one sub-volume.
  Stratum,   ///< Those of all sub-volumes.
};

/// Which numbers of an indexed stratum have a count of the voxels before those of their sub-volumes.
enum class Counts {
  Each,
  Octant, ///< The first, in Morton order, of each octant of 2 x 2 x 2 cells; the masks that numbers lead to
          ///< tell the voxels between.
};

/// How the grids stand that numbers of an indexed stratum lead to.
enum class Grids {
  Masks,   ///< One behind the other, `kIndexedWords` each.
  Octants, ///< By octants that are not empty (voxc/Layout/OctantArray.h).
};

template <>
inline constexpr std::array<std::string_view, 4> kEnumNames<Cells> = {"inline", "word", "slot", "record"};
template <> inline constexpr std::array<std::string_view, 3> kEnumNames<Skip> = {"none", "l1", "octant"};
template <>
inline constexpr std::array<std::string_view, 3> kEnumNames<Empty> = {"zero", "tagged", "transparent"};
template <> inline constexpr std::array<std::string_view, 2> kEnumNames<Counts> = {"each", "octant"};
template <> inline constexpr std::array<std::string_view, 2> kEnumNames<Grids> = {"masks", "octants"};
template <>
inline constexpr std::array<std::string_view, 3> kEnumNames<Sharing> = {"none", "sub-volume", "stratum"};

/// A run of `depth` layers of nodes of one shape: a node's children are the nodes of the layer below, and
/// those of the lowest layer its cells. A sub-volume is one node of the highest layer.
struct Stratum {
  std::string level; ///< The kind of level that it comes from, as IR text names it.
  Int3 log2Shape;    ///< log2 of the children of a node along each axis; equal ones if depth is not 1.
  int depth = 1;     ///< Layers; 0: a sub-volume is one cell.
  int log2Cell = 0;  ///< log2 of the voxels along a cell's side.
  const SlotKind *slots = nullptr; ///< How a node keeps its children.
  bool leaves = false; ///< A child above the lowest layer may be a leaf: all its cells have one value.
  Cells cells = Cells::Inline;
  Skip skip = Skip::None;
  Empty empty = Empty::Zero;
  /// Nothing stands for the value of a cell that is not empty: it is a voxel, and all voxels are equal.
  bool implied = false;
  /// What a slot leads to is followed by a count of voxels, from which the rank of each voxel follows: how
  /// many of the volume come before it in the order of construction.
  bool ranked = false;
  /// Slots have no offsets, but numbers of so many bits: those of the sub-volumes of the next stratum, which
  /// stand in an array from where head word `arrayHead` of the volume says. Number 0 is none. A sub-volume's
  /// place is then that word and `kIndexedWords` for each number before, whether or not it takes so many. The
  /// next stratum has the `arrayHead` too, if its grids stand there by octants.
  int indexBits = 0;
  int arrayHead = 0;
  Counts counts = Counts::Each;
  Grids grids = Grids::Masks;
  std::uint32_t reach = 0; ///< The largest distance stored; 0 without.
  Sharing sharing = Sharing::None;

  bool operator==(const Stratum &) const = default;

  /// log2 of the cells of a sub-volume along each axis.
  Int3 log2Size() const { return {log2Shape.x * depth, log2Shape.y * depth, log2Shape.z * depth}; }
  /// log2 of the children of a node.
  int log2Children() const { return log2Shape.x + log2Shape.y + log2Shape.z; }
  /// Words of one slot: the distance of an empty cell may stand beside its value, and then a count of voxels.
  int slotWords() const {
    return 1 + (skip != Skip::None && empty == Empty::Zero ? 1 : 0) + (ranked ? 1 : 0);
  }
  bool isGrid() const { return cells == Cells::Inline; }
  bool isIndexed() const { return indexBits > 0; }
  /// True if its grids stand in an array by octants.
  bool isInOctants() const { return !isIndexed() && arrayHead > 0; }
  /// Bits of the count of voxels behind a number.
  int countBits() const {
    const int log2Voxels = log2Children() * depth + 3 * log2Cell;
    return !ranked ? 0 : log2Voxels < 32 ? log2Voxels : 32;
  }
  /// Bits of each field of `Skip::Octant`: the alpha of a voxel's word leaves room for less.
  int fieldBits() const { return empty == Empty::Transparent ? 3 : 4; }
  /// Bits of a slot below a reference.
  int tagShift() const { return skip == Skip::Octant && empty == Empty::Tagged ? fieldBits() : 0; }
  /// log2 of the words, or granules, that references of the stratum can reach.
  int log2Reach() const { return empty != Empty::Tagged ? 32 : skip == Skip::Octant ? 28 : 31; }
  /// True if this word of a grid's slot says that its cell is empty.
  bool isEmptySlot(std::uint32_t word) const;
  /// The value in a grid's slot that is not empty.
  std::uint32_t cellValue(std::uint32_t word) const { return word >> tagShift(); }
};

/// The longest of three sizes: of the bounding cube that Morton order speaks of.
inline int longest(Int3 log2) {
  const int xy = log2.x > log2.y ? log2.x : log2.y;
  return xy > log2.z ? xy : log2.z;
}

inline bool Stratum::isEmptySlot(std::uint32_t word) const {
  switch (empty) {
  case Empty::Zero:
    return word == 0;
  case Empty::Tagged:
    return skip == Skip::Octant ? (word & 15) != 0 : word >> 31 != 0;
  case Empty::Transparent:
    return word >> 24 == 0;
  }
  return true;
}

/// The L1 distance in a slot that is empty and not `Zero`.
constexpr std::uint32_t distanceInSlot(std::uint32_t word) { return word & 0x7fffffff; }

} // namespace voxc
