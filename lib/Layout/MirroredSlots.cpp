// Mirrored slots, of trees of 2 x 2 x 2 whose leaves are voxels that are all equal: nodes that are equal but
// for a reflection are one. A node is its masks, then a reference to each child that is neither empty nor a
// leaf. The highest three bits of a reference say across which axes the node there is reflected, x lowest,
// and reflections add up on the way down: child i of a node read with reflection m is its child i ^ m, of
// which the reference is read with m ^ its own.
//
// Jaspe Villanueva, Marton and Gobbetti, "SSVDAGs: Symmetry-aware Sparse Voxel DAGs", I3D 2016.
#include "Masks.h"
#include "Places.h"
#include "TreeCount.h"
#include "Trees.h"

#include <array>

namespace voxc {
namespace {

constexpr int kPlaceBits = 29;

std::string problem(const Stratum &stratum) {
  if (!stratum.implied || stratum.log2Shape != Int3{1, 1, 1})
    return "mirror=yes takes nodes of 2 x 2 x 2 in the last level, with payload=occupancy or "
           "payload=constant";
  return {};
}

/// What a node says, and how it is read.
class MirroredNode {
public:
  MirroredNode(const WordReader &words, const Stratum &stratum, std::uint64_t node)
      : words_(words), begin_(beginOf(stratum, node)), reflection_(node >> kPlaceBits & 7), shape_(stratum),
        masks_(words, shape_, begin_) {}

  Child child(std::uint64_t place) const {
    const std::uint64_t index = place ^ reflection_;
    if (!masks_.exists(index))
      return {};
    if (masks_.isLeaf(index))
      return {.exists = true, .leaf = true, .at = begin_};
    const std::uint64_t reference = words_[begin_ + shape_.words() + masks_.rank(index)];
    return {.exists = true, .leaf = false, .at = reference ^ reflection_ << kPlaceBits};
  }

private:
  const WordReader &words_;
  std::uint64_t begin_;
  std::uint64_t reflection_;
  MaskShape shape_;
  Masks masks_;
};

std::uint64_t wordsWith(const Stratum &stratum, std::uint64_t slots, std::uint64_t) {
  return MaskShape(stratum).words() + slots;
}

std::uint64_t leastWords(const Stratum &stratum) { return wordsWith(stratum, 0, 0); }

std::uint64_t size(const WordReader &words, const Stratum &stratum, std::uint64_t node) {
  return wordsWith(stratum, Masks(words, MaskShape(stratum), beginOf(stratum, node)).slots(), 0);
}

bool check(WordReader &words, const Stratum &stratum, std::uint64_t node, bool lowest) {
  const MaskShape shape(stratum);
  const std::uint64_t begin = beginOf(stratum, node);
  return words.require(begin, shape.words(), "a node's masks") &&
         Masks(words, shape, begin).check(words, lowest) &&
         words.require(begin, size(words, stratum, node), "a node");
}

Child child(const WordReader &words, const Stratum &stratum, std::uint64_t node, Int3 place) {
  return MirroredNode(words, stratum, node).child(mortonCode(place));
}

void visit(const WordReader &words, const Stratum &stratum, std::uint64_t node, ChildVisit visit) {
  const MirroredNode mirrored(words, stratum, node);
  for (std::uint64_t place = 0; place < 8; ++place)
    if (const Child child = mirrored.child(place); child.exists)
      visit(mortonCell(place), child);
}

/// Reflections change no number of cells.
std::uint64_t count(WordReader &words, const Stratum &stratum, std::uint64_t node, int layer) {
  const std::uint64_t begin = beginOf(stratum, node);
  if (begin == 0 || begin >= words.size() || !check(words, stratum, begin, layer == 1))
    return 0;
  const MaskShape shape(stratum);
  return countTree(
      stratum, Masks(words, shape, begin), layer, [](std::uint64_t) { return true; },
      [&](std::uint64_t slot) {
        return count(words, stratum, words[begin + shape.words() + slot], layer - 1);
      });
}

bool relocate(std::span<std::uint32_t> words, const Stratum &stratum, bool, Relocation relocation) {
  for (std::uint64_t slot = MaskShape(stratum).words(); slot < words.size(); ++slot)
    if (!relocateRef(words[slot], relocation))
      return false;
  return !words.empty();
}

double wordsRead(const Stratum &, int layers, bool isEmpty) { return 2 * layers - 1 - (isEmpty ? 0 : 1); }

constexpr std::array<std::string_view, 1> kFiles = {"mirrored"};
std::span<const std::string_view> files(const Stratum &) { return kFiles; }
RuntimeClass writing(const Stratum &) { return {"voxc_mirrored.h", "MirroredSlots"}; }

} // namespace

extern const SlotKind kMirroredSlots = {.name = "mirrored",
                                        .summary = "masks, then references that may reflect their node",
                                        .accessor = files,
                                        .construct = kTree,
                                        .writing = writing,
                                        .forbidsEdits = "keeps nodes that may be reflected, and its words do "
                                                        "not say which of them are their own mirror image",
                                        .root = rootOfLeaves,
                                        .encodings = encodingBits<Leaves>,
                                        .sharing = Sharing::SubVolume,
                                        .countsWords = "say in bits of their own how a node is read",
                                        .placeBits = kPlaceBits,
                                        .sharesMore = true,
                                        .hasChildMask = true,
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
