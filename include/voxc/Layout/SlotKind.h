// The table of slot kinds: each way in which a node keeps its children is described once, with its words, its
// checks, its runtime files and what a look-up costs. A kind is a file of lib/Layout and one or more in
// shaders-runtime/slots and in construct-runtime, of which kinds may share some.
#pragma once

#include "voxc/Layout/Stratum.h"
#include "voxc/Layout/WordReader.h"
#include "voxc/Support/FunctionRef.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace voxc {

/// What a node says of one child.
struct Child {
  bool exists = false; ///< Else it is empty.
  bool leaf = false;   ///< All its cells have the value in the word `at`; else its node begins there.
  std::uint64_t at = 0;
  Ref value = 0; ///< Of a cell, of kinds that say so: its value.
  int log2Around =
      0; ///< Of an empty child: the aligned cube of 2^log2Around children a side around it is empty too.
  // In ranked strata:
  std::uint64_t before = 0;       ///< Voxels of the node before those of the child, of children with slots,
  std::uint64_t leavesBefore = 0; ///< and how many leaves without slots come before it.
  std::uint64_t voxels = 0;       ///< Its own; 0 if its slot does not say.
};

/// How large a region the kernel's accessor finds empty around an empty cell.
enum class EmptyRegion {
  Cell,    ///< The cell; in trees, the child.
  Octant,  ///< The aligned group of 2 x 2 x 2 cells too, by its masks.
  Ahead,   ///< The group, or the grid, if no cell is full to which the ray may still come.
  Octants, ///< The same, but of the cells of other octants no more is known than that there are some.
  Ball,    ///< What is nearer to the cell than its L1 distance says.
  Cube ///< The cube that begins in the cell and goes the ray's way, as many cells a side as the cell says.
};

/// Of kinds for which something never holds.
inline bool never(const Stratum &) { return false; }

/// `SlotKind::region` of kinds whose accessor reports no more than the cell.
inline EmptyRegion cellAlone(const Stratum &) { return EmptyRegion::Cell; }

/// A constant over which the runtime files of a kind are written.
struct SlotConstant {
  std::string_view name;
  std::variant<bool, std::uint32_t> value;
};

/// A class template over the constants of a level, in a header of construct-runtime. Without a name: none.
struct RuntimeClass {
  std::string_view header, name;
};

/// `SlotKind::constants` of kinds whose files have none of their own.
inline std::vector<SlotConstant> noConstants(const Stratum &) { return {}; }

/// Receives a child that is not empty, and its place among its siblings.
using ChildVisit = FunctionRef<void(Int3 place, const Child &child)>;

/// `SlotKind::writing` of kinds whose grids are their words.
inline RuntimeClass nothingToWrite(const Stratum &) { return {}; }

/// Trees of all kinds.
inline constexpr RuntimeClass kTree = {"voxc_tree.h", "Tree"};

/// What construction writes at once.
enum class Block : std::uint32_t {
  Leaf, ///< The word of a leaf (`Stratum::hasLeafWords`).
  Node, ///< A node, or the records of siblings.
};

/// Finds the new place of what a reference leads to; 0 if it leads nowhere.
using Relocation = FunctionRef<Ref(Ref)>;

/// What the kernel's accessor costs: what a model of its speed needs to know.
struct LookUpCost {
  /// Different words that are read to find an empty cell, or one that is not; in trees, through so many
  /// layers.
  double (*words)(const Stratum &stratum, int layers, bool isEmpty);
  /// A number for the cache line that a look-up of the cell of this number (x fastest) begins to read at, of
  /// 16 words, among those of its grid.
  std::uint64_t (*line)(const Stratum &stratum, std::uint64_t cell);
  /// The same of the slot of a cell that is not empty, where it is likely to lie on another line; else none.
  std::optional<std::uint64_t> (*slotLine)(const Stratum &stratum, std::uint64_t cell);
  /// How many times as long a ray takes as its steps and the words that are read say.
  double factor = 1;
};

/// How sub-volumes stand in an array, where numbers lead to them. Construction has a block of `kIndexedWords`
/// for each, the first that of number 0, which is none.
struct ArrayForm {
  /// The words of an array of so many sub-volumes, which have so many octants that are not empty.
  std::uint64_t (*words)(std::uint64_t subVolumes, std::uint64_t octants);
  /// The block of the sub-volume at `at`, in the array that begins at word `array`; the first word is low.
  std::uint64_t (*block)(const WordReader &words, std::uint64_t array, std::uint64_t at);
  /// Writes the array of such blocks by giving its words to `put`, one after the other. Null: the array is
  /// the blocks.
  void (*write)(std::span<const std::uint32_t> blocks, FunctionRef<void(std::uint32_t)> put) = nullptr;
  /// Kernels speak of a sub-volume by its number; else by the word at which it begins.
  bool byNumber = false;
};

struct SlotKind {
  std::string_view name; ///< In plan text.
  std::string_view summary;
  /// The files of a level's accessor, in shaders-runtime/slots.
  std::span<const std::string_view> (*accessor)(const Stratum &stratum);
  /// What builds a sub-volume, and what writes a node, or a grid, when all of it is known: of grids that need
  /// this, and of trees.
  RuntimeClass construct;
  RuntimeClass (*writing)(const Stratum &stratum) = nothingToWrite;
  /// What measures the distances of a grid, and what mends them after an edit; of those that keep some.
  RuntimeClass (*measuring)(const Stratum &stratum) = nothingToWrite;
  RuntimeClass (*mending)(const Stratum &stratum) = nothingToWrite;
  /// What changes a sub-volume. Without a name none can be changed, for this reason, which follows "the
  /// level" and has no full stop.
  RuntimeClass edit = {};
  std::string_view forbidsEdits = {};
  /// Those of these files alone, beside those of all.
  std::vector<SlotConstant> (*constants)(const Stratum &stratum) = noConstants;
  /// Of trees: the class of `kTree.header` that ends a sub-volume. Null: they are none.
  std::string_view (*root)(const Stratum &stratum) = nullptr;
  /// Which alternatives of `Encoding` strata may have: a bit for each, the first lowest.
  unsigned encodings = 1;
  /// What equal blocks are written once where nothing else is asked.
  Sharing sharing = Sharing::None;
  /// The kind of the same nodes with numbers in place of offsets, if there is one.
  std::string_view numbered = {};
  /// Numbers may lead to such nodes, which then stand in an array. Null: they may not.
  const ArrayForm *array = nullptr;
  /// Cells have their values in `Child::value`, not in the words.
  bool givesCells = false;
  /// Whether the words of a grid depend on how many of its octants are not empty.
  bool (*countsOctants)(const Stratum &stratum) = never;
  /// To follow "references": why those to such nodes cannot count granules. "": they can.
  std::string_view countsWords = {};
  /// Bits of a reference that say where a node is; those above say how it is to be read, and go with it.
  int placeBits = 32;
  /// Equal nodes are fewer than a count of equal cubes says.
  bool sharesMore = false;
  /// Empty children have slots too, which may store distances; where they have none, a first value stands at
  /// a known place.
  bool hasEmptySlots = false;
  /// Masks say which children there are, so that cells with implied values need no slots.
  bool hasChildMask = false;
  /// Counts of voxels may stand behind what slots lead to.
  bool ranks = false;
  /// The accessor of kernels loops. One that a device cut short gives an empty span of no cells.
  bool lookUpLoops = false;
  /// How the voxels of a node that is the lowest follow each other in the order of construction, if that is
  /// not Morton order.
  bool ordersVoxelsByRows = false;

  EmptyRegion (*region)(const Stratum &stratum) = cellAlone;
  LookUpCost cost;

  /// What is wrong with such a stratum, or "". The rules of all kinds are `verify`'s.
  std::string (*problem)(const Stratum &stratum);
  /// The same of what its slots lead to below, null where there is nothing: to follow the level below. Null:
  /// any will do.
  std::string (*problemBelow)(const Stratum *below) = nullptr;

  /// True if the node at `node` lies within the words and is well-formed: masks, counts, distances, empty
  /// slots. Else a problem is noted. `lowest`: its children are cells.
  bool (*check)(WordReader &words, const Stratum &stratum, std::uint64_t node, bool lowest);

  /// Words that a node takes at least.
  std::uint64_t (*leastWords)(const Stratum &stratum);

  /// How many words a node with so many slots takes, which lie in so many octants of 2 x 2 x 2 cells; of
  /// siblings, so many records; of a hashed grid with so many cells, the fewest. Octants are asked for
  /// where `countsOctants` says so.
  std::uint64_t (*wordsWith)(const Stratum &stratum, std::uint64_t slots, std::uint64_t octants);

  /// How many words a checked node takes, those of its children apart.
  std::uint64_t (*size)(const WordReader &words, const Stratum &stratum, std::uint64_t node);

  /// How many cells are not empty in a node of this layer, which is checked with all that is below; 1 is the
  /// lowest. 0 if something is wrong, or if only a visit can find out. Null: only a visit ever can.
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

/// The encoding of strata of this kind of which no more is said.
Encoding defaultEncoding(const SlotKind &kind);

/// All slot kinds, in the order of the documentation.
std::span<const SlotKind *const> slotKinds();

/// The kind of this name, or null.
const SlotKind *findSlotKind(std::string_view name);

/// The word at which a node begins, of what a reference or a child says.
inline std::uint64_t beginOf(const Stratum &stratum, std::uint64_t node) {
  const int bits = stratum.slots->placeBits;
  return bits < 32 ? node & ((std::uint64_t{1} << bits) - 1) : node;
}

/// True if the kernel's accessor reports of an empty cell that others around it are empty too.
inline bool reportsEmptyRegion(const Stratum &stratum) {
  return stratum.slots->region(stratum) != EmptyRegion::Cell;
}

/// True if this is a ball around the cell, within which a ray may take several steps.
inline bool reportsBall(const Stratum &stratum) {
  return stratum.slots->region(stratum) == EmptyRegion::Ball;
}

/// True if the kernel's accessor finds a cell by its masks alone, and gives the node in place of a voxel's
/// value, which `value_level_N` then looks up once, when it is hit.
inline bool defersValue(const Stratum &stratum) {
  const EmptyRegion region = stratum.slots->region(stratum);
  return region == EmptyRegion::Octant || region == EmptyRegion::Ahead || region == EmptyRegion::Octants;
}

/// True if each word of a node's mask is followed by how many bits the words before it have.
inline bool countsMaskWords(const Stratum &stratum) {
  return stratum.slots->hasChildMask && stratum.log2Children() > 6 && (!stratum.implied || stratum.ranked);
}

/// `SlotKind::forbidsEdits` of kinds by which numbers come into play.
inline constexpr std::string_view kFixedArray =
    "has numbers in place of references, and the array that they lead to ends where the build left it";

/// To follow the level that numbers should lead to.
inline constexpr std::string_view kMisplacedNumbers =
    " has short pointers, which lead to the last level alone: masked(2, 2, 2) below another masked level, "
    "with payload=occupancy, payload=constant or values=apart";

/// How many times as long a ray takes as its steps and the words that are read say.
double lookUpFactor(std::span<const Stratum> strata);

/// True if strata of this kind may have such an encoding.
inline bool takes(const SlotKind &kind, const Encoding &encoding) {
  return (kind.encodings >> encoding.index() & 1) != 0;
}

} // namespace voxc
