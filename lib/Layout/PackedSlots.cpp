// Packed slots: masks, then the slots of the children that are not empty, in their order. In ranked strata
// the reference of a slot is followed by how many voxels all slots up to this one have; in grids, which are
// not filled in the order of their slots, by how many voxels come before the cell's. In indexed strata there
// is one run of bits in place of slots: the numbers of the children's sub-volumes, then the counts of voxels,
// each of its own or, by octants, those of the first child of each but the first octant, before which are
// none.
#include "Fields.h"
#include "Masks.h"
#include "Places.h"

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

/// How many voxels of a grid of voxels come before that of a bit: in Morton order in one of 4 x 4 x 4, whose
/// colours are then like those next to them, and in the order of the bits in others.
std::uint64_t voxelsBefore(const Masks &masks, const Stratum &stratum, std::uint64_t index) {
  if (!isOfTwoMasks(stratum))
    return masks.earlier(index);
  const auto place = [](std::uint64_t i) {
    return Int3{static_cast<int>(i & 3), static_cast<int>(i >> 2 & 3), static_cast<int>(i >> 4)};
  };
  std::uint64_t before = 0;
  for (std::uint64_t code = 0; code < mortonCode(place(index)); ++code)
    before += masks.exists(gridIndex(stratum.log2Shape, mortonCell(code))) ? 1 : 0;
  return before;
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

Child found(const WordReader &words, const Stratum &stratum, const MaskShape &shape, std::uint64_t node,
            std::uint64_t index) {
  const Masks masks(words, shape, node);
  if (!masks.exists(index)) // In Morton order, eight children in a row are a cube.
    return {.log2Around = !stratum.isGrid() && shape.children > 8 && masks.isGroupEmpty(index) ? 1 : 0};
  const bool isLeaf = stratum.isGrid() || masks.isLeaf(index);
  if (stratum.isIndexed())
    return IndexedNode(words, stratum, masks, node).child(index);
  const std::uint64_t slot =
      node + shape.words() + masks.rank(index) * static_cast<std::uint64_t>(stratum.slotWords());
  const bool isInSlot = stratum.isGrid() || (isLeaf && stratum.cells == Cells::Slot);
  Child child = {true, isLeaf,
                 isLeaf && stratum.implied ? node
                 : isInSlot                ? slot
                                           : words.wordOf(words[slot])};
  if (stratum.ranked)
    rankChild(words, stratum, masks, index, slot, child);
  return child;
}

Child child(const WordReader &words, const Stratum &stratum, std::uint64_t node, Int3 place) {
  return found(words, stratum, MaskShape(stratum), node, childIndex(stratum, place));
}

void visit(const WordReader &words, const Stratum &stratum, std::uint64_t node, ChildVisit visit) {
  const MaskShape shape(stratum);
  if (!stratum.isGrid()) { // Their numbers are in Morton order.
    const Masks masks(words, shape, node);
    for (std::uint64_t index = 0; index < shape.children; ++index)
      if (masks.exists(index))
        visit(mortonCell(index), found(words, stratum, shape, node, index));
    return;
  }
  forEachPlace(stratum, [&](Int3 place) {
    if (const Child child = found(words, stratum, shape, node, childIndex(stratum, place)); child.exists)
      visit(place, child);
  });
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
                                      .child = child,
                                      .visit = visit,
                                      .relocate = relocate};

} // namespace voxc
