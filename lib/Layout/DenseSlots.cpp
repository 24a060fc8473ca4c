// Dense slots: one for each child, x fastest, then y, then z. An empty one may tell its distance, in a word
// beside it or in its own.
#include "Places.h"

#include <algorithm>

namespace voxc {
namespace {

std::string problem(const Stratum &stratum) {
  if (!stratum.isGrid() || stratum.leaves)
    return "dense slots hold the values of cells themselves";
  return {};
}

std::uint64_t slotOf(const Stratum &stratum, std::uint64_t node, Int3 place) {
  return node + static_cast<std::uint64_t>(stratum.slotWords()) * gridIndex(stratum.log2Shape, place);
}

std::uint64_t leastWords(const Stratum &stratum) {
  // Shapes that nobody checked may have 2^63 children.
  return static_cast<std::uint64_t>(stratum.slotWords()) << std::min(stratum.log2Children(), 62);
}

std::uint64_t size(const WordReader &, const Stratum &stratum, std::uint64_t) { return leastWords(stratum); }

/// The distance of a slot; 0 where the cell is not empty.
std::uint32_t distanceOf(const WordReader &words, const Stratum &stratum, std::uint64_t slot) {
  if (stratum.slotWords() == 2)
    return words[slot + 1];
  return isEmptySlot(stratum.empty, words[slot]) ? distanceInSlot(words[slot]) : 0;
}

void checkDistance(WordReader &words, const Stratum &stratum, std::uint64_t slot) {
  const bool empty = isEmptySlot(stratum.empty, words[slot]);
  const std::uint32_t distance = distanceOf(words, stratum, slot);
  if (!empty && distance != 0)
    words.fail("a cell of a distance field is not empty but has a distance");
  else if (empty && (distance == 0 || distance > stratum.reach))
    words.fail("an empty cell of a distance field has a distance outside 1.." +
               std::to_string(stratum.reach));
}

bool check(WordReader &words, const Stratum &stratum, std::uint64_t node, bool) {
  const std::uint64_t count = size(words, stratum, node);
  if (!words.require(node, count, "a grid"))
    return false;
  if (stratum.skip == Skip::L1)
    for (std::uint64_t slot = node; slot < node + count;
         slot += static_cast<std::uint64_t>(stratum.slotWords()))
      checkDistance(words, stratum, slot);
  return !words.problem();
}

Child child(const WordReader &words, const Stratum &stratum, std::uint64_t node, Int3 place) {
  const std::uint64_t slot = slotOf(stratum, node, place);
  return isEmptySlot(stratum.empty, words[slot]) ? Child{} : Child{true, true, slot};
}

void visit(const WordReader &words, const Stratum &stratum, std::uint64_t node, ChildVisit visit) {
  forEachPlace(stratum, [&](Int3 place) {
    if (const Child found = child(words, stratum, node, place); found.exists)
      visit(place, found);
  });
}

bool relocate(std::span<std::uint32_t> words, const Stratum &stratum, bool holdsVoxels,
              Relocation relocation) {
  for (std::size_t i = 0; i < words.size() && !holdsVoxels;
       i += static_cast<std::size_t>(stratum.slotWords()))
    if (!isEmptySlot(stratum.empty, words[i]) && !relocateRef(words[i], relocation))
      return false;
  return true;
}

} // namespace

const SlotKind kDenseSlots = {
    "dense", "a slot for each child", problem, check, leastWords, size, child, visit, relocate};

} // namespace voxc
