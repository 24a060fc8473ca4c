// Packed slots: masks, then the slots of the children that are not empty, in their order. In ranked strata
// the reference of a slot is followed by how many voxels all slots up to this one have; in grids, which are
// not filled in the order of their slots, by how many voxels come before the cell's. In indexed strata there
// is one run of bits in place of slots: the numbers of the children's sub-volumes, then the counts of voxels,
// each of its own or, by octants, those of the first child of each but the first octant, before which are
// none.
#include "Fields.h"
#include "Masks.h"
#include "Places.h"
#include "TreeCount.h"

#include "voxc/Layout/OctantArray.h"

#include <bit>

namespace voxc {
namespace {

/// A grid whose mask is two words, which the accessor takes as a whole.
bool isOfTwoMasks(const Stratum &stratum) { return stratum.isGrid() && stratum.log2Shape == Int3{2, 2, 2}; }

std::string problem(const Stratum &stratum) {
  if (stratum.cells == Cells::Record)
    return "packed slots are words; records stand with their siblings";
  if (stratum.leaves && stratum.log2Children() > 6)
    return "a node with leaves has 64 children at most";
  if (stratum.log2Children() > 32)
    return "a masked grid has 2^32 cells at most, so that a cell's number is a word";
  return {};
}

std::uint64_t leastWords(const Stratum &stratum) {
  return MaskShape(stratum).words() + (stratum.implied ? 0 : static_cast<std::uint64_t>(stratum.slotWords()));
}

std::uint64_t wordsWith(const Stratum &stratum, std::uint64_t slots, std::uint64_t octants) {
  const std::uint64_t head = MaskShape(stratum).words();
  if (!stratum.isIndexed())
    return head + slots * static_cast<std::uint64_t>(stratum.slotWords());
  const std::uint64_t counts = stratum.counts == Counts::Each ? slots : octants - (octants > 0 ? 1 : 0);
  const std::uint64_t bits = slots * static_cast<std::uint64_t>(stratum.indexBits) +
                             counts * static_cast<std::uint64_t>(stratum.countBits());
  return head + wordsOfFields(bits, 1);
}

/// Bits of the octants of a grid of two masks that are not empty, of which bit 2x + 8y + 32z stands for
/// octant (x, y, z): that of its first cell.
std::uint64_t octantsOf(const WordReader &words, std::uint64_t grid) {
  std::uint64_t bits = words[grid] | std::uint64_t{words[grid + 1]} << 32;
  for (const int side : {16, 4, 1})
    bits |= bits >> side;
  return bits & 0x0000'0505'0000'0505;
}

/// How many octants of a node are not empty; 0 where that is not asked for.
std::uint64_t octants(const WordReader &words, const Stratum &stratum, std::uint64_t node) {
  return stratum.counts == Counts::Octant ? static_cast<std::uint64_t>(std::popcount(octantsOf(words, node)))
                                          : 0;
}

std::uint64_t size(const WordReader &words, const Stratum &stratum, std::uint64_t node) {
  return wordsWith(stratum, Masks(words, MaskShape(stratum), node).slots(), octants(words, stratum, node));
}

bool check(WordReader &words, const Stratum &stratum, std::uint64_t node, bool lowest) {
  const MaskShape shape(stratum);
  return words.require(node, shape.words(), "a node's masks") &&
         Masks(words, shape, node).check(words, lowest) &&
         // Fields are read two words at a time, the last of a node too.
         words.require(node, size(words, stratum, node) + (stratum.isIndexed() ? 1 : 0), "a node");
}

/// The bits of the cells of a grid of two masks, in Morton order: the bits of a cell's number are those of x,
/// then of y, then of z, and three swaps of two of them make x, y, z, x, y, z.
std::uint64_t inMortonOrder(std::uint64_t cells) {
  const auto swap = [&](std::uint64_t mask, int distance) {
    const std::uint64_t differ = (cells ^ cells >> distance) & mask;
    cells ^= differ ^ differ << distance;
  };
  swap(0x0c0c'0c0c'0c0c'0c0c, 2);  // Bits 1 and 2 of a number.
  swap(0x0000'f0f0'0000'f0f0, 12); // 2 and 4.
  swap(0x0000'ff00'0000'ff00, 8);  // 3 and 4.
  return cells;
}

/// How many voxels of a grid of voxels come before that of a bit: in Morton order in one of 4 x 4 x 4, whose
/// colours are then like those next to them, and in the order of the bits in others.
std::uint64_t voxelsBefore(const Masks &masks, const Stratum &stratum, std::uint64_t index) {
  if (!isOfTwoMasks(stratum))
    return masks.earlier(index);
  const std::uint64_t before = (inMortonOrder(std::uint64_t{1} << index) - 1) & inMortonOrder(masks.all());
  return static_cast<std::uint64_t>(std::popcount(before));
}

/// What a ranked stratum says of the voxels of a child, whose slot is at `slot` or, if it has none, would be.
void rankChild(const WordReader &words, const Stratum &stratum, const Masks &masks, std::uint64_t index,
               std::uint64_t slot, Child &child) {
  const bool hasSlot = !(child.leaf && stratum.implied);
  if (stratum.isGrid()) {
    child.before = hasSlot ? words[slot + 1] : 0;
    child.leavesBefore = hasSlot ? 0 : voxelsBefore(masks, stratum, index);
    return;
  }
  child.before = masks.rank(index) > 0 ? words[slot - 1] : 0;
  child.leavesBefore = stratum.implied ? masks.earlierLeaves(index) : 0;
  child.voxels = hasSlot ? words[slot + 1] - child.before : 0;
}

/// A node of an indexed stratum, which is a grid.
class IndexedNode {
public:
  IndexedNode(const WordReader &words, const Stratum &stratum, const Masks &masks, std::uint64_t node)
      : words_(words), stratum_(stratum), masks_(masks), node_(node),
        numbers_(node + MaskShape(stratum).words()),
        countBit_(masks.slots() * static_cast<std::uint64_t>(stratum.indexBits)) {}

  Child child(std::uint64_t index) const {
    Child child = {.exists = true, .leaf = true, .at = node_};
    child.value = subVolume(index);
    if (stratum_.ranked)
      child.before = stratum_.counts == Counts::Octant ? beforeInOctant(index) : count(masks_.rank(index));
    return child;
  }

private:
  /// Where the sub-volume of a child is.
  Ref subVolume(std::uint64_t index) const {
    const std::uint64_t number = readField(words_, numbers_, masks_.rank(index), stratum_.indexBits);
    const std::uint64_t begin = words_[static_cast<std::uint64_t>(stratum_.arrayHead)];
    // Beyond what offsets reach lies nothing.
    const std::uint64_t at = begin + kIndexedWords * number;
    return number == 0 || at >= kMaxWords ? 0 : static_cast<Ref>(at);
  }

  std::uint64_t count(std::uint64_t i) const {
    const int bits = stratum_.countBits();
    return readBits(words_, numbers_, countBit_ + i * static_cast<std::uint64_t>(bits), bits);
  }

  /// The voxels before a child: those before its octant, and those of the children before it there.
  std::uint64_t beforeInOctant(std::uint64_t index) const {
    const std::uint64_t first = index & ~std::uint64_t{0b010101};
    const std::uint64_t octants = octantsOf(words_, node_) & ((std::uint64_t{1} << first) - 1);
    const auto earlier = static_cast<std::uint64_t>(std::popcount(octants));
    std::uint64_t before = earlier == 0 ? 0 : count(earlier - 1);
    // In an octant the order of the bits is that of Morton.
    for (std::uint64_t other = first; other < index; ++other)
      if ((other & ~std::uint64_t{0b010101}) == first && masks_.exists(other))
        before += voxelsOf(subVolume(other));
    return before;
  }

  std::uint64_t voxelsOf(Ref grid) const {
    if (grid == 0)
      return 0;
    const std::uint64_t array = words_[static_cast<std::uint64_t>(stratum_.arrayHead)];
    const std::uint64_t cells =
        stratum_.grids == Grids::Octants
            ? cellsOf(words_, octantGrid(words_, array, (grid - array) / kIndexedWords))
            : words_[grid] | std::uint64_t{words_[std::uint64_t{grid} + 1]} << 32;
    return static_cast<std::uint64_t>(std::popcount(cells));
  }

  const WordReader &words_;
  const Stratum &stratum_;
  const Masks &masks_;
  std::uint64_t node_;
  std::uint64_t numbers_;
  std::uint64_t countBit_; ///< Of the first count, in the run of bits that begins with the numbers.
};

/// The child of a bit that is set, whose slot is at `slot` or, if it has none, would be.
Child childAt(const WordReader &words, const Stratum &stratum, const Masks &masks, std::uint64_t node,
              std::uint64_t index, bool isLeaf, std::uint64_t slot) {
  const bool isInSlot = stratum.isGrid() || (isLeaf && stratum.cells == Cells::Slot);
  Child child = {true, isLeaf,
                 isLeaf && stratum.implied ? node
                 : isInSlot                ? slot
                                           : words.wordOf(words[slot])};
  if (stratum.ranked)
    rankChild(words, stratum, masks, index, slot, child);
  return child;
}

Child found(const WordReader &words, const Stratum &stratum, const MaskShape &shape, std::uint64_t node,
            std::uint64_t index) {
  const Masks masks(words, shape, node);
  if (!masks.exists(index)) // In Morton order, eight children in a row are a cube.
    return {.log2Around = !stratum.isGrid() && shape.children > 8 && masks.isGroupEmpty(index) ? 1 : 0};
  if (stratum.isIndexed())
    return IndexedNode(words, stratum, masks, node).child(index);
  const std::uint64_t slot =
      node + shape.words() + masks.rank(index) * static_cast<std::uint64_t>(stratum.slotWords());
  return childAt(words, stratum, masks, node, index, stratum.isGrid() || masks.isLeaf(index), slot);
}

Child child(const WordReader &words, const Stratum &stratum, std::uint64_t node, Int3 place) {
  return found(words, stratum, MaskShape(stratum), node, childIndex(stratum, place));
}

/// The children of a node of a tree, in the order of their bits, which is Morton order.
void visitTree(const WordReader &words, const Stratum &stratum, const MaskShape &shape, std::uint64_t node,
               ChildVisit visit) {
  const Masks masks(words, shape, node);
  const std::uint64_t leaves = masks.allLeaves();
  std::uint64_t slot = node + shape.words();
  for (std::uint64_t rest = masks.all(); rest != 0; rest &= rest - 1) {
    const auto index = static_cast<std::uint64_t>(std::countr_zero(rest));
    const bool isLeaf = (leaves >> index & 1) != 0;
    visit(mortonCell(index), childAt(words, stratum, masks, node, index, isLeaf, slot));
    slot += isLeaf && stratum.implied ? 0 : static_cast<std::uint64_t>(stratum.slotWords());
  }
}

void visit(const WordReader &words, const Stratum &stratum, std::uint64_t node, ChildVisit visit) {
  const MaskShape shape(stratum);
  if (!stratum.isGrid() && shape.children <= 64)
    return visitTree(words, stratum, shape, node, visit);
  if (isOfTwoMasks(stratum)) {
    for (std::uint64_t rest = inMortonOrder(Masks(words, shape, node).all()); rest != 0; rest &= rest - 1) {
      const Int3 place = mortonCell(static_cast<std::uint64_t>(std::countr_zero(rest)));
      visit(place, found(words, stratum, shape, node, gridIndex(stratum.log2Shape, place)));
    }
    return;
  }
  forEachPlace(stratum, [&](Int3 place) {
    if (const Child child = found(words, stratum, shape, node, childIndex(stratum, place)); child.exists)
      visit(place, child);
  });
}

/// The cells of a grid of voxels; 0 if one has no value.
std::uint64_t countGrid(const WordReader &words, const Stratum &stratum, const Masks &masks,
                        std::uint64_t slots) {
  bool isRight = true;
  for (std::uint64_t slot = slots;
       slot < slots + masks.slots() * static_cast<std::uint64_t>(stratum.slotWords());
       slot += static_cast<std::uint64_t>(stratum.slotWords()))
    isRight &= stratum.cellValue(words[slot]) != 0;
  return isRight ? masks.count() : 0;
}

std::uint64_t count(WordReader &words, const Stratum &stratum, std::uint64_t node, int layer) {
  const bool isTold = !stratum.isIndexed() && !(stratum.ranked && layer > 1);
  if (!isTold || node == 0 || node >= words.size() || !check(words, stratum, node, layer == 1))
    return 0;
  const MaskShape shape(stratum);
  const Masks masks(words, shape, node);
  const std::uint64_t slots = node + shape.words();
  if (stratum.isGrid())
    return countGrid(words, stratum, masks, slots);
  const auto target = [&](std::uint64_t slot) {
    return words.wordOf(words[slots + slot * static_cast<std::uint64_t>(stratum.slotWords())]);
  };
  if (layer > 1 || stratum.cells == Cells::Word)
    for (std::uint64_t i = 0; i < masks.slots(); ++i)
      words.fetch(target(i));
  return countTree(
      stratum, masks, layer,
      [&](std::uint64_t slot) {
        const std::uint64_t at = stratum.cells == Cells::Word ? target(slot) : slots + slot;
        return at != 0 && stratum.cellValue(words[at]) != 0;
      },
      [&](std::uint64_t slot) { return count(words, stratum, target(slot), layer - 1); });
}

bool relocateNumbers(std::span<std::uint32_t> words, const Stratum &stratum, Relocation relocation) {
  const WordReader reader(words);
  const MaskShape shape(stratum);
  const std::uint64_t slots = Masks(reader, shape, 0).slots();
  if (words.size() != size(reader, stratum, 0))
    return false;
  for (std::uint64_t i = 0; i < slots; ++i) {
    std::uint32_t number = readField(reader, shape.words(), i, stratum.indexBits);
    if (!relocateRef(number, relocation))
      return false;
    writeField(words.subspan(shape.words()), i, stratum.indexBits, number);
  }
  return true;
}

bool relocate(std::span<std::uint32_t> words, const Stratum &stratum, bool holdsVoxels,
              Relocation relocation) {
  const std::uint64_t head = MaskShape(stratum).words();
  if (words.size() < head)
    return false;
  if (stratum.isGrid() && holdsVoxels)
    return true;
  if (stratum.isIndexed())
    return relocateNumbers(words, stratum, relocation);
  const bool leavesStay = holdsVoxels && stratum.cells == Cells::Slot && !stratum.implied;
  if (!leavesStay) {
    for (std::uint64_t slot = head; slot < words.size();
         slot += static_cast<std::uint64_t>(stratum.slotWords()))
      if (!relocateRef(words[slot], relocation))
        return false;
    return true;
  }
  const WordReader reader(words);
  const MaskShape shape(stratum);
  const Masks masks(reader, shape, 0);
  if (words.size() != head + masks.slots())
    return false;
  for (std::uint64_t child = 0; child < shape.children; ++child)
    if (masks.exists(child) && !masks.isLeaf(child) &&
        !relocateRef(words[head + masks.rank(child)], relocation))
      return false;
  return true;
}

} // namespace

extern const SlotKind kPackedSlots = {.name = "packed",
                                      .summary = "masks, then a slot for each child that is not empty",
                                      .gridFiles = "masked",
                                      .tellsByMasks = true,
                                      .ranks = true,
                                      .indexes = true,
                                      .tellsGap = isOfTwoMasks,
                                      .findsValueLater = isOfTwoMasks,
                                      .problem = problem,
                                      .check = check,
                                      .leastWords = leastWords,
                                      .wordsWith = wordsWith,
                                      .size = size,
                                      .count = count,
                                      .child = child,
                                      .visit = visit,
                                      .relocate = relocate};

} // namespace voxc
