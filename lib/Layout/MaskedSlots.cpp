// Masked slots, of grids: a bit for each cell, and the slots of those that are not empty.
#include "MaskedGrid.h"
#include "Places.h"

#include <array>

namespace voxc {
namespace {

std::string problem(const Stratum &stratum) {
  if (stratum.log2Children() > 32)
    return "a masked grid has 2^32 cells at most, so that a cell's number is a word";
  return {};
}

Child found(const WordReader &words, const Stratum &stratum, const Masks &masks, std::uint64_t node,
            std::uint64_t index) {
  if (!masks.exists(index))
    return {};
  return maskedCell(words, stratum, masks, node, index, stratum.implied ? masks.earlier(index) : 0);
}

Child child(const WordReader &words, const Stratum &stratum, std::uint64_t node, Int3 place) {
  const MaskShape shape(stratum);
  return found(words, stratum, Masks(words, shape, node), node, gridIndex(stratum.log2Shape, place));
}

void visit(const WordReader &words, const Stratum &stratum, std::uint64_t node, ChildVisit visit) {
  const MaskShape shape(stratum);
  const Masks masks(words, shape, node);
  forEachPlace(stratum, [&](Int3 place) {
    const Child child = found(words, stratum, masks, node, gridIndex(stratum.log2Shape, place));
    if (child.exists)
      visit(place, child);
  });
}

double wordsRead(const Stratum &stratum, int, bool isEmpty) {
  return isEmpty || stratum.implied ? 1 : countsMaskWords(stratum) ? 3 : 2;
}

constexpr std::array<std::string_view, 6> kAccessor = {"masked/head",  "masked/rank", "masked/there",
                                                       "masked/slots", "masked/cell", "cell"};
std::span<const std::string_view> accessor(const Stratum &) { return kAccessor; }
RuntimeClass writing(const Stratum &) { return {"voxc_masked.h", "MaskWriting"}; }

} // namespace

extern const SlotKind kMaskedSlots = {.name = "masked",
                                      .summary =
                                          "a mask of the cells, then a slot for each that is not empty",
                                      .accessor = accessor,
                                      .construct = kMaskedGrid,
                                      .writing = writing,
                                      .edit = kEditedMasked,
                                      .numbered = "numbered",
                                      .hasChildMask = true,
                                      .ranks = true,
                                      .ordersVoxelsByRows = true,
                                      .cost = {wordsRead, maskLine, maskedSlotLine},
                                      .problem = problem,
                                      .check = checkMasked,
                                      .leastWords = maskedLeastWords,
                                      .wordsWith = maskedWordsWith,
                                      .size = maskedSize,
                                      .count = countMasked,
                                      .child = child,
                                      .visit = visit,
                                      .relocate = relocateMasked};

} // namespace voxc
