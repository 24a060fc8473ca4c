// Numbered slots: a masked grid, or a brick, whose cells are told by numbers in place of offsets. Behind the
// mask stands one run of bits: the numbers of the cells that are not empty, then, in ranked strata, counts of
// the voxels before theirs, one for each or, by octants, one for the first cell of each octant but the first,
// before which are none.
#include "Bricks.h"
#include "Fields.h"
#include "MaskedGrid.h"
#include "Places.h"

#include <array>
#include <bit>

namespace voxc {
namespace {

std::string problem(const Stratum &stratum) {
  const Numbers &numbers = *stratum.numbers();
  if (numbers.bits < 1 || numbers.bits > 31)
    return "numbers have 1 to 31 bits, not " + std::to_string(numbers.bits);
  if (stratum.log2Children() > kMaxLog2IndexedCells)
    return "it has more than 2^" + std::to_string(kMaxLog2IndexedCells) +
           " cells, too many for short pointers; two masked levels in its place would do";
  if (numbers.counts == VoxelCountsOf::Octant && !stratum.ranked)
    return "counts of octants are counts of voxels, which stand behind short pointers with values=apart";
  return {};
}

std::string problemOfMasked(const Stratum &stratum) {
  if (stratum.numbers()->counts == VoxelCountsOf::Octant)
    return "counts of octants stand behind the short pointers of a masked(2, 2, 2)";
  return problem(stratum);
}

std::string problemOfBrick(const Stratum &stratum) {
  const std::string problemOfShape = brickProblem(stratum);
  return problemOfShape.empty() ? problem(stratum) : problemOfShape;
}

std::string problemBelow(const Stratum *below) {
  const bool leadsOn = below && below->implied && below->slots->array;
  return leadsOn ? "" : std::string(kMisplacedNumbers);
}

bool countsOctants(const Stratum &stratum) { return stratum.numbers()->counts == VoxelCountsOf::Octant; }

constexpr std::string_view kCountsWords = "of short pointers lead to an array in 2^32 words";

std::uint64_t wordsWith(const Stratum &stratum, std::uint64_t slots, std::uint64_t octants) {
  const Numbers &numbers = *stratum.numbers();
  const std::uint64_t counts =
      numbers.counts == VoxelCountsOf::Each ? slots : octants - (octants > 0 ? 1 : 0);
  const std::uint64_t bits = slots * static_cast<std::uint64_t>(numbers.bits) +
                             counts * static_cast<std::uint64_t>(stratum.countBits());
  return MaskShape(stratum).words() + wordsOfFields(bits, 1);
}

std::uint64_t size(const WordReader &words, const Stratum &stratum, std::uint64_t node) {
  const std::uint64_t octants =
      countsOctants(stratum) ? static_cast<std::uint64_t>(std::popcount(brickOctants(brickMask(words, node))))
                             : 0;
  return wordsWith(stratum, Masks(words, MaskShape(stratum), node).slots(), octants);
}

bool check(WordReader &words, const Stratum &stratum, std::uint64_t node, bool lowest) {
  const MaskShape shape(stratum);
  return words.require(node, shape.words(), "a node's masks") &&
         Masks(words, shape, node).check(words, lowest) &&
         // Fields are read two words at a time, the last of a node too.
         words.require(node, size(words, stratum, node) + 1, "a node");
}

/// A grid whose slots are numbers.
class NumberedNode {
public:
  NumberedNode(const WordReader &words, const Stratum &stratum, const Masks &masks, std::uint64_t node)
      : words_(words), stratum_(stratum), own_(*stratum.numbers()), masks_(masks), node_(node),
        numbersAt_(node + MaskShape(stratum).words()),
        countBit_(masks.slots() * static_cast<std::uint64_t>(own_.bits)) {}

  Child child(std::uint64_t index) const {
    Child child = {.exists = true, .leaf = true, .at = node_};
    child.value = subVolume(index);
    if (stratum_.ranked)
      child.before = own_.counts == VoxelCountsOf::Octant ? beforeInOctant(index) : count(masks_.rank(index));
    return child;
  }

private:
  /// Where the sub-volume of a child is.
  Ref subVolume(std::uint64_t index) const {
    const std::uint64_t number = readField(words_, numbersAt_, masks_.rank(index), own_.bits);
    const std::uint64_t begin = words_[static_cast<std::uint64_t>(own_.arrayHead)];
    // Beyond what offsets reach lies nothing.
    const std::uint64_t at = begin + kIndexedWords * number;
    return number == 0 || at >= kMaxWords ? 0 : static_cast<Ref>(at);
  }

  std::uint64_t count(std::uint64_t i) const {
    const int bits = stratum_.countBits();
    return readBits(words_, numbersAt_, countBit_ + i * static_cast<std::uint64_t>(bits), bits);
  }

  /// The voxels before a child: those before its octant, and those of the children before it there.
  std::uint64_t beforeInOctant(std::uint64_t index) const {
    const std::uint64_t first = index & ~std::uint64_t{0b010101};
    const std::uint64_t octants = brickOctants(brickMask(words_, node_)) & ((std::uint64_t{1} << first) - 1);
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
    const std::uint64_t array = words_[static_cast<std::uint64_t>(own_.arrayHead)];
    return static_cast<std::uint64_t>(std::popcount(own_.leadsTo->array->block(words_, array, grid)));
  }

  const WordReader &words_;
  const Stratum &stratum_;
  const Numbers &own_;
  const Masks &masks_;
  std::uint64_t node_;
  std::uint64_t numbersAt_;
  std::uint64_t countBit_; ///< Of the first count, in the run of bits that begins with the numbers.
};

Child child(const WordReader &words, const Stratum &stratum, std::uint64_t node, Int3 place) {
  const MaskShape shape(stratum);
  const Masks masks(words, shape, node);
  const std::uint64_t index = gridIndex(stratum.log2Shape, place);
  return masks.exists(index) ? NumberedNode(words, stratum, masks, node).child(index) : Child{};
}

void visit(const WordReader &words, const Stratum &stratum, std::uint64_t node, ChildVisit visit) {
  const MaskShape shape(stratum);
  const Masks masks(words, shape, node);
  const NumberedNode numbered(words, stratum, masks, node);
  forEachPlace(stratum, [&](Int3 place) {
    const std::uint64_t index = gridIndex(stratum.log2Shape, place);
    if (masks.exists(index))
      visit(place, numbered.child(index));
  });
}

bool relocate(std::span<std::uint32_t> words, const Stratum &stratum, bool, Relocation relocation) {
  const WordReader reader(words);
  const MaskShape shape(stratum);
  const std::uint64_t slots = Masks(reader, shape, 0).slots();
  if (words.size() != size(reader, stratum, 0))
    return false;
  for (std::uint64_t i = 0; i < slots; ++i) {
    std::uint32_t number = readField(reader, shape.words(), i, stratum.numbers()->bits);
    if (!relocateRef(number, relocation))
      return false;
    writeField(words.subspan(shape.words()), i, stratum.numbers()->bits, number);
  }
  return true;
}

double wordsRead(const Stratum &stratum, int, bool isEmpty) {
  return isEmpty ? 1 : countsMaskWords(stratum) ? 3 : 2;
}

/// A number is a field in two words, and leads on from where the array begins.
double wordsReadOfBrick(const Stratum &, int, bool isEmpty) { return isEmpty ? 2 : 5; }

constexpr std::array<std::string_view, 7> kAccessor = {
    "numbered/head", "masked/rank", "masked/there", "numbered/slots", "numbered/rank", "masked/cell", "cell"};
constexpr std::array<std::string_view, 6> kBrickAccessor = {"numbered/head",  "masked/rank",   "masked/there",
                                                            "numbered/slots", "numbered/rank", "brick/cell"};
constexpr std::array<std::string_view, 7> kOctantAccessor = {
    "numbered/head",          "masked/rank",   "masked/there", "numbered/slots",
    "numbered/octant_counts", "numbered/rank", "brick/cell"};
std::span<const std::string_view> accessor(const Stratum &) { return kAccessor; }
std::span<const std::string_view> accessorOfBrick(const Stratum &stratum) {
  if (countsOctants(stratum))
    return kOctantAccessor;
  return kBrickAccessor;
}
RuntimeClass writing(const Stratum &) { return {"voxc_numbered.h", "NumberedWriting"}; }

std::vector<SlotConstant> constants(const Stratum &stratum) {
  const Numbers &numbers = *stratum.numbers();
  const ArrayForm *const array = numbers.leadsTo ? numbers.leadsTo->array : nullptr;
  return {{"POINTER_BITS", static_cast<std::uint32_t>(numbers.bits)},
          {"ARRAY_HEAD", static_cast<std::uint32_t>(numbers.arrayHead)},
          {"OCTANT_COUNTS", countsOctants(stratum)},
          {"LEADS_BY_NUMBER", array && array->byNumber}};
}

} // namespace

extern const SlotKind kNumberedSlots = {.name = "numbered",
                                        .summary = "a mask of the cells, then a number for each not empty",
                                        .accessor = accessor,
                                        .construct = kMaskedGrid,
                                        .writing = writing,
                                        .forbidsEdits = kFixedArray,
                                        .constants = constants,
                                        .encodings = encodingBits<Numbers>,
                                        .givesCells = true,
                                        .countsOctants = countsOctants,
                                        .countsWords = kCountsWords,
                                        .hasChildMask = true,
                                        .ranks = true,
                                        .ordersVoxelsByRows = true,
                                        .cost = {wordsRead, maskLine, maskedSlotLine},
                                        .problem = problemOfMasked,
                                        .problemBelow = problemBelow,
                                        .check = check,
                                        .leastWords = maskedLeastWords,
                                        .wordsWith = wordsWith,
                                        .size = size,
                                        .child = child,
                                        .visit = visit,
                                        .relocate = relocate};

extern const SlotKind kNumberedBrickSlots = {.name = "numbered-brick",
                                             .summary = "64 bits for 4 x 4 x 4 cells, then numbers",
                                             .accessor = accessorOfBrick,
                                             .construct = kMaskedGrid,
                                             .writing = writing,
                                             .forbidsEdits = kFixedArray,
                                             .constants = constants,
                                             .encodings = encodingBits<Numbers>,
                                             .givesCells = true,
                                             .countsOctants = countsOctants,
                                             .countsWords = kCountsWords,
                                             .hasChildMask = true,
                                             .ranks = true,
                                             .region = brickRegion,
                                             .cost = {wordsReadOfBrick},
                                             .problem = problemOfBrick,
                                             .problemBelow = problemBelow,
                                             .check = check,
                                             .leastWords = maskedLeastWords,
                                             .wordsWith = wordsWith,
                                             .size = size,
                                             .child = child,
                                             .visit = visit,
                                             .relocate = relocate};

} // namespace voxc
