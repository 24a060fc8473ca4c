// Strata: how the words of a volume lie, as data. A level of a format lowers to a stratum; whatever reads,
// checks, moves, writes or traces words is driven by this record, and nothing else knows a layout.
#pragma once

#include "voxc/Support/EnumText.h"
#include "voxc/Support/Geometry.h"

#include <cstdint>
#include <string>
#include <variant>

namespace voxc {

struct SlotKind;

/// Where something begins in the words of a volume, counted in words or, past 2^32 of them, in granules
/// (voxc/Layout/Layout.h). 0 leads nowhere.
using Ref = std::uint32_t;

/// log2 of the cells of a brick: a masked grid whose mask is two words.
inline constexpr Int3 kLog2BrickShape = {2, 2, 2};

/// Words that construction writes of a sub-volume which stands in an array: a bit a cell.
inline constexpr int kLog2IndexedWords = 1;
inline constexpr std::uint64_t kIndexedWords = std::uint64_t{1} << kLog2IndexedWords;

/// log2 of the most cells of a grid whose slots are numbers: kernels count the bits of a run of them in a
/// word.
inline constexpr int kMaxLog2IndexedCells = 26;

/// The most words that references can reach, if they count words.
inline constexpr std::uint64_t kMaxWords = std::uint64_t{1} << 32;

/// log2 of the most words of a granule.
inline constexpr int kMaxLog2Granule = 8;

/// What an empty cell says about the cells around it.
enum class Metric {
  L1,     ///< The L1 distance to the nearest cell of the sub-volume that is not empty, `reach` at most.
  Octant, ///< For each octant of directions, how many cells a side the largest empty cube has that begins in
          ///< the cell and goes that way, `reach` at most: eight fields in one word, that of the octant in
          ///< which x, y and z rise as bits 0, 1 and 2 say at its number. A cube may leave the volume, and no
          ///< other sub-volume.
};

/// Where the distance of an empty cell stands.
enum class DistancePlace {
  Beside, ///< In a second word of its slot, whose first is 0.
  InSlot, ///< In the slot itself, which `Empty` distinguishes from those that are not empty.
};

/// Which slots are empty. Where it is not `Zero`, the rest of an empty slot holds its distance.
enum class Empty {
  Zero,   ///< Those of 0.
  Tagged, ///< Those with a tag, and references have fewer bits: 31, and the highest bit is the tag; beside
          ///< octants 28, above a field of 0.
  Transparent, ///< Those whose alpha, the highest byte, is 0: no voxel of the volume is.
};

/// Where the value of a leaf of a tree stands.
enum class LeafPlace {
  Apart,  ///< In a word of its own, which the slot of a leaf refers to, so that equal ones are shared.
  InSlot, ///< In the slot of a leaf.
};

/// Which equal blocks are written once.
enum class Sharing {
  None,
  SubVolume, ///< Those of one sub-volume.
  Level,     ///< Those of all sub-volumes.
};

/// Which numbers have a count of the voxels before those of their sub-volumes.
enum class VoxelCountsOf {
  Each,
  Octant, ///< The first, in Morton order, of each octant of 2 x 2 x 2 cells; the masks that numbers lead to
          ///< give the voxels between.
};

template <> inline constexpr std::array<std::string_view, 2> kEnumNames<Metric> = {"l1", "octant"};
template <>
inline constexpr std::array<std::string_view, 2> kEnumNames<DistancePlace> = {"beside", "in-slot"};
template <> inline constexpr std::array<std::string_view, 2> kEnumNames<LeafPlace> = {"apart", "in-slot"};
template <> inline constexpr std::array<std::string_view, 2> kEnumNames<VoxelCountsOf> = {"each", "octant"};

// What slots of some kinds have beside what all have.

/// Slots of a grid whose empty cells have some too, which say how far the next full cell is.
struct Distances {
  Metric metric = Metric::L1;
  std::uint32_t reach = 0; ///< The largest distance stored.
  DistancePlace place = DistancePlace::Beside;

  bool operator==(const Distances &) const = default;
};

/// Slots that are numbers: of the sub-volumes of the next stratum, which stand in an array from where head
/// word `arrayHead` of the volume says. Number 0 is none. A sub-volume's place is then that word and
/// `kIndexedWords` for each number before, whether or not it takes so many.
struct Numbers {
  int bits = 0; ///< Of a number.
  VoxelCountsOf counts = VoxelCountsOf::Each;
  // What follows from the layout.
  int arrayHead = 0;
  const SlotKind *leadsTo = nullptr; ///< The slots of the sub-volumes.

  bool operator==(const Numbers &) const = default;
};

/// Nodes of trees: a child above the lowest layer may be a leaf, all of whose cells have one value.
struct Leaves {
  LeafPlace place = LeafPlace::Apart;

  bool operator==(const Leaves &) const = default;
};

/// Nodes of trees as records, each next to those of its siblings. A leaf is the record of one: its value
/// stands in the first word, and its masks are 0.
struct Records {
  bool operator==(const Records &) const = default;
};

/// One of these; grids of other kinds have nothing of their own.
using Encoding = std::variant<std::monostate, Distances, Numbers, Leaves, Records>;

/// The bits of these alternatives, as `SlotKind::encodings` has them.
template <typename... Alternatives>
inline constexpr unsigned encodingBits = ((1u << Encoding(Alternatives{}).index()) | ...);

/// A run of `depth` layers of nodes of one shape: a node's children are the nodes of the layer below, and
/// those of the lowest layer its cells. A sub-volume is one node of the highest layer.
struct Stratum {
  std::string level; ///< The kind of level that it comes from, as IR text names it.
  Int3 log2Shape;    ///< log2 of the children of a node along each axis; equal ones if depth is not 1.
  int depth = 1;     ///< Layers; 0: a sub-volume is one cell.
  int log2Cell = 0;  ///< log2 of the voxels along a cell's side.
  const SlotKind *slots = nullptr; ///< How a node keeps its children.
  Encoding encoding;               ///< What slots of this kind have of their own.
  Sharing sharing = Sharing::None;

  // What follows from the layout (`Layout::complete`).
  bool lowest = false; ///< Its cells are voxels.
  /// Nothing stands for the value of a cell that is not empty: it is a voxel, and all voxels are equal.
  bool implied = false;
  /// What a slot leads to is followed by a count of voxels, from which the rank of each voxel follows: how
  /// many of the volume come before it in the order of construction.
  bool ranked = false;
  /// Of sub-volumes that stand in an array and have numbers: the bits of a number, and the head word of the
  /// volume that says where the array begins. 0: they stand among other nodes.
  int numberBits = 0;
  int arrayHead = 0;

  bool operator==(const Stratum &) const = default;

  /// log2 of the cells of a sub-volume along each axis.
  Int3 log2Size() const { return {log2Shape.x * depth, log2Shape.y * depth, log2Shape.z * depth}; }
  /// log2 of the children of a node.
  int log2Children() const { return log2Shape.x + log2Shape.y + log2Shape.z; }

  /// The encoding if it is this one, else null.
  const Distances *distances() const { return std::get_if<Distances>(&encoding); }
  const Numbers *numbers() const { return std::get_if<Numbers>(&encoding); }
  const Leaves *leaves() const { return std::get_if<Leaves>(&encoding); }

  bool hasRecords() const { return std::holds_alternative<Records>(encoding); }
  bool isGrid() const { return !leaves() && !hasRecords(); }
  /// True of a tree that has nodes: one of depth 0 is a single leaf.
  bool hasLayers() const { return !isGrid() && depth > 0; }
  /// True if sub-volumes stand in an array.
  bool inArray() const { return numberBits > 0; }
  bool leavesInSlots() const { return leaves() && leaves()->place == LeafPlace::InSlot; }
  /// True if leaves have words of their own, which slots refer to.
  bool hasLeafWords() const { return leaves() && !leavesInSlots() && !implied; }
  bool measures(Metric metric) const { return distances() && distances()->metric == metric; }
  /// Words of one slot: the distance of an empty cell may stand beside its value, and then a count of voxels.
  int slotWords() const {
    return 1 + (distances() && distances()->place == DistancePlace::Beside ? 1 : 0) + (ranked ? 1 : 0);
  }
  Empty empty() const {
    const bool isInSlot = distances() && distances()->place == DistancePlace::InSlot;
    return !isInSlot ? Empty::Zero : lowest ? Empty::Transparent : Empty::Tagged;
  }
  /// Bits of the count of voxels behind a number.
  int countBits() const {
    const int log2Voxels = log2Children() * depth + 3 * log2Cell;
    return !ranked ? 0 : log2Voxels < 32 ? log2Voxels : 32;
  }
  /// Bits of each field of `Metric::Octant`: the alpha of a voxel's word leaves room for less.
  int fieldBits() const { return empty() == Empty::Transparent ? 3 : 4; }
  /// Bits of a slot below a reference.
  int tagShift() const { return measures(Metric::Octant) && empty() == Empty::Tagged ? fieldBits() : 0; }
  /// log2 of the words, or granules, that references of the stratum can reach.
  int log2Reach() const { return empty() != Empty::Tagged ? 32 : measures(Metric::Octant) ? 28 : 31; }
  /// True if this word of a grid's slot says that its cell is empty.
  bool isEmptySlot(std::uint32_t word) const;
  /// The value in a grid's slot that is not empty.
  std::uint32_t cellValue(std::uint32_t word) const { return word >> tagShift(); }
};

/// The longest of three sizes: of the bounding cube that Morton order speaks of.
inline int maxComponent(Int3 log2) {
  const int xy = log2.x > log2.y ? log2.x : log2.y;
  return xy > log2.z ? xy : log2.z;
}

inline bool Stratum::isEmptySlot(std::uint32_t word) const {
  switch (empty()) {
  case Empty::Zero:
    return word == 0;
  case Empty::Tagged:
    return measures(Metric::Octant) ? (word & 15) != 0 : word >> 31 != 0;
  case Empty::Transparent:
    return word >> 24 == 0;
  }
  return true;
}

/// The L1 distance in a slot that is empty and not `Zero`.
constexpr std::uint32_t distanceInSlot(std::uint32_t word) { return word & 0x7fffffff; }

} // namespace voxc
