// Brick slots: a masked grid of 4 x 4 x 4 cells. Its two words of mask are taken as a whole, so that a
// look-up tells of the cells around an empty one, and its voxels follow each other in Morton order, by which
// their colours are like those next to them.
#include "Bricks.h"
#include "MaskedGrid.h"
#include "Places.h"

#include <array>
#include <bit>

namespace voxc {

std::string brickProblem(const Stratum &stratum) {
  return stratum.log2Shape == kLog2BrickShape ? "" : "a brick has 4 x 4 x 4 cells";
}

std::uint64_t brickMask(const WordReader &words, std::uint64_t brick) {
  return words[brick] | std::uint64_t{words[brick + 1]} << 32;
}

std::uint64_t brickOctants(std::uint64_t mask) {
  for (const int side : {16, 4, 1})
    mask |= mask >> side;
  return mask & 0x0000'0505'0000'0505;
}

/// The bits of a cell's number are those of x, then of y, then of z, and three swaps of two of them make x,
/// y, z, x, y, z.
std::uint64_t inMortonOrder(std::uint64_t mask) {
  const auto swap = [&](std::uint64_t bits, int distance) {
    const std::uint64_t differ = (mask ^ mask >> distance) & bits;
    mask ^= differ ^ differ << distance;
  };
  swap(0x0c0c'0c0c'0c0c'0c0c, 2);  // Bits 1 and 2 of a number.
  swap(0x0000'f0f0'0000'f0f0, 12); // 2 and 4.
  swap(0x0000'ff00'0000'ff00, 8);  // 3 and 4.
  return mask;
}

EmptyRegion brickRegion(const Stratum &stratum) {
  // Of voxels, half a mask alone is read.
  return stratum.lowest ? EmptyRegion::Octant : EmptyRegion::Ahead;
}

namespace {

/// How many voxels come before that of a bit.
std::uint64_t voxelsBefore(std::uint64_t mask, std::uint64_t index) {
  const std::uint64_t before = (inMortonOrder(std::uint64_t{1} << index) - 1) & inMortonOrder(mask);
  return static_cast<std::uint64_t>(std::popcount(before));
}

Child child(const WordReader &words, const Stratum &stratum, std::uint64_t node, Int3 place) {
  const MaskShape shape(stratum);
  const Masks masks(words, shape, node);
  const std::uint64_t index = gridIndex(stratum.log2Shape, place);
  const std::uint64_t mask = brickMask(words, node);
  if ((mask >> index & 1) == 0)
    return {};
  return maskedCell(words, stratum, masks, node, index,
                    stratum.ranked && stratum.implied ? voxelsBefore(mask, index) : 0);
}

void visit(const WordReader &words, const Stratum &stratum, std::uint64_t node, ChildVisit visit) {
  for (std::uint64_t rest = inMortonOrder(brickMask(words, node)); rest != 0; rest &= rest - 1) {
    const Int3 place = mortonCell(static_cast<std::uint64_t>(std::countr_zero(rest)));
    visit(place, child(words, stratum, node, place));
  }
}

/// Number 0 is none.
std::uint64_t arrayWords(std::uint64_t bricks, std::uint64_t) { return kIndexedWords * (bricks + 1); }

std::uint64_t block(const WordReader &words, std::uint64_t, std::uint64_t at) { return brickMask(words, at); }

constexpr ArrayForm kArray = {.words = arrayWords, .block = block};

double wordsRead(const Stratum &stratum, int, bool isEmpty) {
  return brickRegion(stratum) == EmptyRegion::Octant ? 1 : isEmpty ? 2 : 3;
}

constexpr std::array<std::string_view, 5> kAccessor = {"masked/head", "masked/rank", "masked/there",
                                                       "masked/slots", "brick/cell"};
constexpr std::array<std::string_view, 4> kOfVoxels = {"masked/head", "brick/rank", "masked/there",
                                                       "brick/cell"};

std::span<const std::string_view> accessor(const Stratum &stratum) {
  if (stratum.implied)
    return kOfVoxels;
  return kAccessor;
}

RuntimeClass writing(const Stratum &stratum) {
  if (stratum.implied)
    return {"voxc_brick.h", "BrickWriting"};
  return {"voxc_masked.h", "MaskWriting"};
}

} // namespace

extern const SlotKind kBrickSlots = {.name = "brick",
                                     .summary = "64 bits for 4 x 4 x 4 cells, then a slot for each not empty",
                                     .accessor = accessor,
                                     .construct = kMaskedGrid,
                                     .writing = writing,
                                     .edit = kEditedMasked,
                                     .numbered = "numbered-brick",
                                     .array = &kArray,
                                     .hasChildMask = true,
                                     .ranks = true,
                                     .region = brickRegion,
                                     .cost = {wordsRead},
                                     .problem = brickProblem,
                                     .check = checkMasked,
                                     .leastWords = maskedLeastWords,
                                     .wordsWith = maskedWordsWith,
                                     .size = maskedSize,
                                     .count = countMasked,
                                     .child = child,
                                     .visit = visit,
                                     .relocate = relocateMasked};

} // namespace voxc
