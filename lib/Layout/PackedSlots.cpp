// Packed slots, of trees: masks, then the slots of the children that are not empty, in their order. In ranked
// strata the reference of a slot is followed by how many voxels all slots up to this one have.
#include "Masks.h"
#include "Places.h"
#include "TreeCount.h"
#include "Trees.h"

#include <array>
#include <bit>

namespace voxc {
namespace {

std::string problem(const Stratum &stratum) {
  if (stratum.log2Children() > 6)
    return "a node with leaves has 64 children at most";
  return {};
}

std::uint64_t leastWords(const Stratum &stratum) {
  return MaskShape(stratum).words() + (stratum.implied ? 0 : static_cast<std::uint64_t>(stratum.slotWords()));
}

std::uint64_t wordsWith(const Stratum &stratum, std::uint64_t slots, std::uint64_t) {
  return MaskShape(stratum).words() + slots * static_cast<std::uint64_t>(stratum.slotWords());
}

std::uint64_t size(const WordReader &words, const Stratum &stratum, std::uint64_t node) {
  return wordsWith(stratum, Masks(words, MaskShape(stratum), node).slots(), 0);
}

bool check(WordReader &words, const Stratum &stratum, std::uint64_t node, bool lowest) {
  const MaskShape shape(stratum);
  return words.require(node, shape.words(), "a node's masks") &&
         Masks(words, shape, node).check(words, lowest) &&
         words.require(node, size(words, stratum, node), "a node");
}

/// What a ranked stratum says of the voxels of a child, whose slot is at `slot` or, if it has none, would be.
void rankChild(const WordReader &words, const Stratum &stratum, const Masks &masks, std::uint64_t index,
               std::uint64_t slot, Child &child) {
  const bool hasSlot = !(child.leaf && stratum.implied);
  child.before = masks.rank(index) > 0 ? words[slot - 1] : 0;
  child.leavesBefore = stratum.implied ? masks.earlierLeaves(index) : 0;
  child.voxels = hasSlot ? words[slot + 1] - child.before : 0;
}

/// The child of a bit that is set, whose slot is at `slot` or, if it has none, would be.
Child childAt(const WordReader &words, const Stratum &stratum, const Masks &masks, std::uint64_t node,
              std::uint64_t index, bool isLeaf, std::uint64_t slot) {
  const bool isInSlot = isLeaf && stratum.leavesInSlots();
  Child child = {true, isLeaf,
                 isLeaf && stratum.implied ? node
                 : isInSlot                ? slot
                                           : words.wordOf(words[slot])};
  if (stratum.ranked)
    rankChild(words, stratum, masks, index, slot, child);
  return child;
}

Child child(const WordReader &words, const Stratum &stratum, std::uint64_t node, Int3 place) {
  const MaskShape shape(stratum);
  const Masks masks(words, shape, node);
  const std::uint64_t index = childIndex(stratum, place);
  if (!masks.exists(index)) // In Morton order, eight children in a row are a cube.
    return {.log2Around = shape.children > 8 && masks.isGroupEmpty(index) ? 1 : 0};
  const std::uint64_t slot =
      node + shape.words() + masks.rank(index) * static_cast<std::uint64_t>(stratum.slotWords());
  return childAt(words, stratum, masks, node, index, masks.isLeaf(index), slot);
}

/// In the order of the bits, which is Morton order.
void visit(const WordReader &words, const Stratum &stratum, std::uint64_t node, ChildVisit visit) {
  const MaskShape shape(stratum);
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

std::uint64_t count(WordReader &words, const Stratum &stratum, std::uint64_t node, int layer) {
  const bool isTold = !(stratum.ranked && layer > 1);
  if (!isTold || node == 0 || node >= words.size() || !check(words, stratum, node, layer == 1))
    return 0;
  const MaskShape shape(stratum);
  const Masks masks(words, shape, node);
  const std::uint64_t slots = node + shape.words();
  const auto target = [&](std::uint64_t slot) {
    return words.wordOf(words[slots + slot * static_cast<std::uint64_t>(stratum.slotWords())]);
  };
  if (layer > 1 || !stratum.leavesInSlots())
    for (std::uint64_t i = 0; i < masks.slots(); ++i)
      words.fetch(target(i));
  return countTree(
      stratum, masks, layer,
      [&](std::uint64_t slot) {
        const std::uint64_t at = stratum.leavesInSlots() ? slots + slot : target(slot);
        return at != 0 && stratum.cellValue(words[at]) != 0;
      },
      [&](std::uint64_t slot) { return count(words, stratum, target(slot), layer - 1); });
}

bool relocate(std::span<std::uint32_t> words, const Stratum &stratum, bool holdsVoxels,
              Relocation relocation) {
  const std::uint64_t head = MaskShape(stratum).words();
  if (words.size() < head)
    return false;
  const bool leavesStay = holdsVoxels && stratum.leavesInSlots() && !stratum.implied;
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

/// A layer is its masks, two words of those of more than 16 children, and a reference for each that has a
/// child.
double wordsRead(const Stratum &stratum, int layers, bool isEmpty) {
  const int found = isEmpty ? layers - 1 : layers;
  const int masks = stratum.log2Shape.x <= 1 ? 1 : 2;
  const int leaf = isEmpty ? 0 : stratum.implied ? -1 : stratum.leavesInSlots() ? 0 : 1;
  return masks * layers + found + leaf;
}

constexpr std::array<std::string_view, 2> kNode = {"packed/slot", "packed/node"};
constexpr std::array<std::string_view, 2> kWideNode = {"packed/slot", "packed/wide"};
std::span<const std::string_view> accessor(const Stratum &stratum) {
  return MaskShape(stratum).hasTwoSets() ? kWideNode : kNode;
}

RuntimeClass writing(const Stratum &) { return {"voxc_packed.h", "PackedSlots"}; }

} // namespace

extern const SlotKind kPackedSlots = {.name = "packed",
                                      .summary = "masks, then a slot for each child that is not empty",
                                      .accessor = accessor,
                                      .construct = kTree,
                                      .writing = writing,
                                      .edit = kEditedTree,
                                      .root = rootOfLeaves,
                                      .encodings = encodingBits<Leaves>,
                                      .sharing = Sharing::SubVolume,
                                      .hasChildMask = true,
                                      .ranks = true,
                                      .cost = {.words = wordsRead},
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
