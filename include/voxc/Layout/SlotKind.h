// The table of slot kinds: each way in which a node keeps its children is described once. A kind is a file of
// lib/Layout and one of its name in shaders-runtime/slots and in construct-runtime/slots; where it serves
// grids and trees, these have a file each.
#pragma once

#include "voxc/Layout/Stratum.h"
#include "voxc/Layout/WordReader.h"
#include "voxc/Support/FunctionRef.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace voxc {

/// What a node says of one child.
struct Child {
  bool exists = false; ///< Else it is empty.
  bool leaf = false;   ///< All its cells have the value in the word `at`; else its node begins there.
  std::uint64_t at = 0;
  Ref value = 0; ///< Of a cell of an indexed stratum: where its sub-volume is.
  int log2Around =
      0; ///< Of an empty child: the aligned cube of 2^log2Around children a side around it is empty too.
  // In ranked strata:
  std::uint64_t before = 0;       ///< Voxels of the node before those of the child, of children with slots,
  std::uint64_t leavesBefore = 0; ///< and how many leaves without slots come before it.
  std::uint64_t voxels = 0;       ///< Its own; 0 if its slot does not say.
};

/// Receives a child that is not empty, and its place among its siblings.
using ChildVisit = FunctionRef<void(Int3 place, const Child &child)>;

/// What construction writes at once.
enum class Block : std::uint32_t {
  Leaf, ///< The word of a cell, of `Cells::Word`.
  Node, ///< A node, or the records of siblings.
};

/// Finds the new place of what a reference leads to; 0 if it leads nowhere.
using Relocation = FunctionRef<Ref(Ref)>;

struct SlotKind {
  std::string_view name; ///< In plan text, and of its runtime files.
  std::string_view summary;
  /// The name of its runtime files for grids, if those of its own name are for trees alone.
  std::string_view gridFiles = {};
  /// Empty children have slots too, which may tell distances; where they have none, a first value stands at
  /// a known place.
  bool keepsEmpty = false;
  /// Masks tell which children there are, so that cells with implied values need no slots.
  bool tellsByMasks = false;
  /// Counts of voxels may stand behind what slots lead to.
  bool ranks = false;
  /// Slots may have numbers in place of offsets.
  bool indexes = false;
  /// References lead to records that stand side by side.
  bool sharesBlocks = false;
  /// The accessor of kernels loops. One that a device cut short gives a gap of no cells.
  bool lookUpLoops = false;
  /// True if the accessor of kernels tells of an empty cell that others around it are empty too.
  bool (*tellsGap)(const Stratum &stratum);
  /// True if the accessor of kernels tells a cell from its masks alone, and gives the node in place of a
  /// voxel's value, which `value_level_N` then looks up once, when it is hit.
  bool (*findsValueLater)(const Stratum &stratum);

  /// What is wrong with such a stratum, or "". The rules of all kinds are `verify`'s.
  std::string (*problem)(const Stratum &stratum);

  /// True if the node at `node` lies within the words and is well-formed: masks, counts, distances, empty
  /// slots. Else a problem is noted. `lowest`: its children are cells.
  bool (*check)(WordReader &words, const Stratum &stratum, std::uint64_t node, bool lowest);

  /// Words that a node takes at least.
  std::uint64_t (*leastWords)(const Stratum &stratum);

  /// How many words a node with so many slots takes, which lie in so many octants of 2 x 2 x 2 cells; of
  /// siblings, so many records; of a hashed grid with so many cells, the fewest. Octants are asked for by
  /// `Counts::Octant` alone.
  std::uint64_t (*wordsWith)(const Stratum &stratum, std::uint64_t slots, std::uint64_t octants);

  /// How many words a checked node takes, those of its children apart.
  std::uint64_t (*size)(const WordReader &words, const Stratum &stratum, std::uint64_t node);

  /// How many cells are not empty in a node of this layer, which is checked with all that is below; 1 is the
  /// lowest. 0 if something is wrong, or if only a visit tells. Null: only a visit ever tells.
  std::uint64_t (*count)(WordReader &words, const Stratum &stratum, std::uint64_t node, int layer) = nullptr;

  /// The child of a node at a place below the shape.
  Child (*child)(const WordReader &words, const Stratum &stratum, std::uint64_t node, Int3 place);

  /// Visits the children of a checked node that are not empty, in Morton order.
  void (*visit)(const WordReader &words, const Stratum &stratum, std::uint64_t node, ChildVisit visit);

  /// Moves the references of a node or of siblings. `holdsVoxels`: the cells of the stratum are voxels, and
  /// stay. False if one leads nowhere, or the words are no such block.
  bool (*relocate)(std::span<std::uint32_t> words, const Stratum &stratum, bool holdsVoxels,
                   Relocation relocation);
};

/// All slot kinds, in the order of the documentation.
std::span<const SlotKind *const> slotKinds();

/// The kind of this name, or null.
const SlotKind *findSlotKind(std::string_view name);

/// The name of the runtime files for the nodes of a stratum.
inline std::string_view runtimeFilesOf(const Stratum &stratum) {
  const SlotKind &kind = *stratum.slots;
  return stratum.isGrid() && !kind.gridFiles.empty() ? kind.gridFiles : kind.name;
}

/// `tellsGap` and `findsValueLater` of kinds that never do.
inline bool never(const Stratum &) { return false; }

} // namespace voxc
