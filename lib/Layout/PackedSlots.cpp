// Packed slots: masks, then the slots of the children that are not empty, in their order. In ranked strata
// the reference of a slot is followed by how many voxels all slots up to this one have; in grids, which are
// not filled in the order of their slots, by how many voxels come before the cell's. In indexed strata there
// are two runs of fields in place of slots: the numbers of the children's sub-volumes, then the counts of
// voxels.
#include "Fields.h"
#include "Masks.h"
#include "Places.h"

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

std::uint64_t wordsWith(const Stratum &stratum, std::uint64_t slots) {
  const std::uint64_t head = MaskShape(stratum).words();
  if (stratum.isIndexed())
    return head + wordsOfFields(slots, stratum.indexBits) + wordsOfFields(slots, stratum.countBits());
  return head + slots * static_cast<std::uint64_t>(stratum.slotWords());
}

std::uint64_t size(const WordReader &words, const Stratum &stratum, std::uint64_t node) {
  return wordsWith(stratum, Masks(words, MaskShape(stratum), node).slots());
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

/// The child of an indexed stratum, which is a grid, that has so many slots before its own.
Child indexedChild(const WordReader &words, const Stratum &stratum, const MaskShape &shape,
                   const Masks &masks, std::uint64_t node, std::uint64_t rank) {
  const std::uint64_t numbers = node + shape.words();
  const std::uint64_t counts = numbers + wordsOfFields(masks.slots(), stratum.indexBits);
  const std::uint64_t number = readField(words, numbers, rank, stratum.indexBits);
  const std::uint64_t begin = words[static_cast<std::uint64_t>(stratum.arrayHead)];
  Child child = {.exists = true, .leaf = true, .at = node};
  // Beyond what offsets reach lies nothing.
  const std::uint64_t at = begin + kIndexedWords * number;
  child.value = number == 0 || at >= kMaxWords ? 0 : static_cast<Ref>(at);
  if (stratum.ranked)
    child.before = readField(words, counts, rank, stratum.countBits());
  return child;
}

Child found(const WordReader &words, const Stratum &stratum, const MaskShape &shape, std::uint64_t node,
            std::uint64_t index) {
  const Masks masks(words, shape, node);
  if (!masks.exists(index)) // In Morton order, eight children in a row are a cube.
    return {.log2Around = !stratum.isGrid() && shape.children > 8 && masks.isGroupEmpty(index) ? 1 : 0};
  const bool isLeaf = stratum.isGrid() || masks.isLeaf(index);
  if (stratum.isIndexed())
    return indexedChild(words, stratum, shape, masks, node, masks.rank(index));
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
