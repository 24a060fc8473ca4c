// Sibling slots: a node's record is [first child, masks], and the records of its children that are not empty
// stand together, in their order. The record of a leaf is [value, 0].
#include "Masks.h"
#include "Places.h"
#include "TreeCount.h"
#include "Trees.h"

#include <array>

namespace voxc {
namespace {

std::string problem(const Stratum &stratum) {
  if (stratum.log2Children() > 3)
    return "a record of siblings has one word of masks, for 8 children at most";
  return {};
}

std::uint64_t recordWords(const MaskShape &shape) { return 1 + shape.words(); }

std::uint64_t leastWords(const Stratum &stratum) { return recordWords(MaskShape(stratum)); }

std::uint64_t wordsWith(const Stratum &stratum, std::uint64_t slots, std::uint64_t) {
  return slots * recordWords(MaskShape(stratum));
}

std::uint64_t size(const WordReader &, const Stratum &stratum, std::uint64_t) { return leastWords(stratum); }

bool check(WordReader &words, const Stratum &stratum, std::uint64_t node, bool lowest) {
  const MaskShape shape(stratum);
  return words.require(node, recordWords(shape), "a node of an octree") &&
         Masks(words, shape, node + 1).check(words, lowest);
}

Child found(const WordReader &words, const MaskShape &shape, std::uint64_t node, std::uint64_t index) {
  const Masks masks(words, shape, node + 1);
  if (!masks.exists(index))
    return {.log2Around = shape.children > 8 && masks.isGroupEmpty(index) ? 1 : 0};
  return {true, masks.isLeaf(index), words.wordOf(words[node]) + recordWords(shape) * masks.rank(index)};
}

Child child(const WordReader &words, const Stratum &stratum, std::uint64_t node, Int3 place) {
  return found(words, MaskShape(stratum), node, childIndex(stratum, place));
}

void visit(const WordReader &words, const Stratum &stratum, std::uint64_t node, ChildVisit visit) {
  const MaskShape shape(stratum);
  forEachPlace(stratum, [&](Int3 place) {
    if (const Child child = found(words, shape, node, childIndex(stratum, place)); child.exists)
      visit(place, child);
  });
}

std::uint64_t count(WordReader &words, const Stratum &stratum, std::uint64_t node, int layer) {
  if (node >= words.size() || !check(words, stratum, node, layer == 1))
    return 0;
  const MaskShape shape(stratum);
  const Masks masks(words, shape, node + 1);
  const std::uint64_t children = words.wordOf(words[node]);
  const std::uint64_t step = recordWords(shape);
  if (children == 0 || children + masks.count() * step > words.size())
    return 0;
  return countTree(
      stratum, masks, layer,
      [&](std::uint64_t child) {
        const std::uint64_t at = children + child * step;
        bool isLeaf = stratum.cellValue(words[at]) != 0;
        for (std::uint64_t i = 1; i < step; ++i)
          isLeaf &= words[at + i] == 0;
        return isLeaf;
      },
      [&](std::uint64_t child) { return count(words, stratum, children + child * step, layer - 1); });
}

/// Records without masks are leaves, and their first word is a value.
bool relocate(std::span<std::uint32_t> words, const Stratum &stratum, bool holdsVoxels,
              Relocation relocation) {
  const std::uint64_t step = recordWords(MaskShape(stratum));
  if (words.size() % step != 0)
    return false;
  for (std::size_t i = 0; i < words.size(); i += step) {
    bool isLeaf = true;
    for (const std::uint32_t mask : words.subspan(i + 1, step - 1))
      isLeaf &= mask == 0;
    if (!(isLeaf && holdsVoxels) && !relocateRef(words[i], relocation))
      return false;
  }
  return true;
}

/// A layer is a record of masks and of a reference.
double wordsRead(const Stratum &, int layers, bool isEmpty) { return 2 * layers - (isEmpty ? 1 : 0); }

constexpr std::array<std::string_view, 1> kFiles = {"siblings"};
std::span<const std::string_view> files(const Stratum &) { return kFiles; }
RuntimeClass writing(const Stratum &) { return {"voxc_siblings.h", "SiblingSlots"}; }
std::string_view root(const Stratum &) { return "RecordRoot"; }

} // namespace

extern const SlotKind kSiblingSlots = {.name = "siblings",
                                       .summary =
                                           "a record for each child that is not empty, next to each other",
                                       .accessor = files,
                                       .construct = kTree,
                                       .writing = writing,
                                       .edit = kEditedTree,
                                       .root = root,
                                       .encodings = encodingBits<Records>,
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
