// Grids with a mask of their cells: the mask, then the slots of the cells that are not empty, in the order of
// the bits. In ranked strata a slot says, after its value, how many voxels come before those of its cell:
// grids are not filled in the order of their slots.
#include "MaskedGrid.h"

#include "Places.h"

namespace voxc {
namespace {

constexpr int kLog2LineWords = 4;
/// Cells a word of a mask.
constexpr int kLog2MaskCells = 5;
/// Cells whose slots lie on one line, about: of a surface, one in eight is not empty.
constexpr int kLog2SlotCells = 7;

std::uint64_t slotWords(const Stratum &stratum) { return static_cast<std::uint64_t>(stratum.slotWords()); }

} // namespace

std::uint64_t maskedLeastWords(const Stratum &stratum) {
  return MaskShape(stratum).words() + (stratum.implied ? 0 : slotWords(stratum));
}

std::uint64_t maskedWordsWith(const Stratum &stratum, std::uint64_t slots, std::uint64_t) {
  return MaskShape(stratum).words() + slots * slotWords(stratum);
}

std::uint64_t maskedSize(const WordReader &words, const Stratum &stratum, std::uint64_t node) {
  return maskedWordsWith(stratum, Masks(words, MaskShape(stratum), node).slots(), 0);
}

bool checkMasked(WordReader &words, const Stratum &stratum, std::uint64_t node, bool lowest) {
  const MaskShape shape(stratum);
  return words.require(node, shape.words(), "a node's masks") &&
         Masks(words, shape, node).check(words, lowest) &&
         words.require(node, maskedSize(words, stratum, node), "a node");
}

Child maskedCell(const WordReader &words, const Stratum &stratum, const Masks &masks, std::uint64_t node,
                 std::uint64_t index, std::uint64_t earlier) {
  if (stratum.implied)
    return {.exists = true, .leaf = true, .at = node, .leavesBefore = stratum.ranked ? earlier : 0};
  const std::uint64_t slot = node + MaskShape(stratum).words() + masks.rank(index) * slotWords(stratum);
  return {.exists = true, .leaf = true, .at = slot, .before = stratum.ranked ? words[slot + 1] : 0};
}

/// The cells of a grid of voxels; 0 if one has no value.
std::uint64_t countMasked(WordReader &words, const Stratum &stratum, std::uint64_t node, int layer) {
  if (node == 0 || node >= words.size() || !checkMasked(words, stratum, node, layer == 1))
    return 0;
  const MaskShape shape(stratum);
  const Masks masks(words, shape, node);
  const std::uint64_t slots = node + shape.words();
  bool isRight = true;
  for (std::uint64_t slot = slots; slot < slots + masks.slots() * slotWords(stratum);
       slot += slotWords(stratum))
    isRight &= stratum.cellValue(words[slot]) != 0;
  return isRight ? masks.count() : 0;
}

bool relocateMasked(std::span<std::uint32_t> words, const Stratum &stratum, bool holdsVoxels,
                    Relocation relocation) {
  const std::uint64_t head = MaskShape(stratum).words();
  if (words.size() < head)
    return false;
  for (std::uint64_t slot = head; slot < words.size() && !holdsVoxels; slot += slotWords(stratum))
    if (!relocateRef(words[slot], relocation))
      return false;
  return true;
}

std::uint64_t maskLine(const Stratum &stratum, std::uint64_t cell) {
  return cell >> (kLog2LineWords + kLog2MaskCells - (countsMaskWords(stratum) ? 1 : 0));
}

std::optional<std::uint64_t> maskedSlotLine(const Stratum &stratum, std::uint64_t cell) {
  return countsMaskWords(stratum) && !stratum.implied ? std::optional(cell >> kLog2SlotCells) : std::nullopt;
}

} // namespace voxc
