// Octant slots: bricks of voxels that numbers lead to, in an array of their own form. What stands for the
// place of a node is that of two words a brick (`Numbers`); a block of construction is these two words, a bit
// a cell in Morton order.
#include "Bricks.h"
#include "Places.h"

#include "voxc/Layout/OctantArray.h"

#include <array>
#include <bit>

namespace voxc {
namespace {

std::string problem(const Stratum &stratum) {
  if (!stratum.inArray())
    return "octants stand in an array, which numbers in the level above lead to";
  return stratum.implied ? brickProblem(stratum) : "octants are those of voxels without values";
}

std::uint64_t arrayOf(const WordReader &words, const Stratum &stratum) {
  return words[static_cast<std::uint64_t>(stratum.arrayHead)];
}

std::uint64_t block(const WordReader &words, std::uint64_t array, std::uint64_t at) {
  return cellsOf(words, octantGrid(words, array, (at - array) / kIndexedWords));
}

std::uint64_t maskOf(const WordReader &words, const Stratum &stratum, std::uint64_t node) {
  return block(words, arrayOf(words, stratum), node);
}

std::uint64_t leastWords(const Stratum &) { return kIndexedWords; }
std::uint64_t wordsWith(const Stratum &, std::uint64_t, std::uint64_t) { return kIndexedWords; }
std::uint64_t size(const WordReader &, const Stratum &, std::uint64_t) { return kIndexedWords; }

bool check(WordReader &words, const Stratum &stratum, std::uint64_t node, bool) {
  const std::uint64_t array = arrayOf(words, stratum);
  return checkOctantGrid(words, array, (node - array) / kIndexedWords, stratum.ranked);
}

std::uint64_t count(WordReader &words, const Stratum &stratum, std::uint64_t node, int layer) {
  return check(words, stratum, node, layer == 1)
             ? static_cast<std::uint64_t>(std::popcount(maskOf(words, stratum, node)))
             : 0;
}

/// The cell of a bit that is set.
Child found(const Stratum &stratum, std::uint64_t node, std::uint64_t mask, std::uint64_t index) {
  const std::uint64_t before = mask & ((std::uint64_t{1} << index) - 1);
  return {.exists = true,
          .leaf = true,
          .at = node,
          .leavesBefore = stratum.ranked ? static_cast<std::uint64_t>(std::popcount(before)) : 0};
}

Child child(const WordReader &words, const Stratum &stratum, std::uint64_t node, Int3 place) {
  const std::uint64_t mask = maskOf(words, stratum, node);
  const std::uint64_t index = mortonCode(place);
  return (mask >> index & 1) != 0 ? found(stratum, node, mask, index) : Child{};
}

void visit(const WordReader &words, const Stratum &stratum, std::uint64_t node, ChildVisit visit) {
  const std::uint64_t mask = maskOf(words, stratum, node);
  for (std::uint64_t index = 0; index < 64; ++index)
    if ((mask >> index & 1) != 0)
      visit(mortonCell(index), found(stratum, node, mask, index));
}

/// Voxels lead nowhere.
bool relocate(std::span<std::uint32_t> words, const Stratum &, bool holdsVoxels, Relocation) {
  return holdsVoxels && words.size() == kIndexedWords;
}

EmptyRegion region(const Stratum &) { return EmptyRegion::Octants; }

/// Words tell what is read of masks, and not the work to find a place in them: 1.1 to 1.4 where it was
/// measured (docs/notes/2026-11-23-sizes.md).
constexpr double kCost = 1.2;

/// The array's begin, the head, octants, and cells where the octant has some.
double wordsRead(const Stratum &, int, bool isEmpty) { return isEmpty ? 5 : 6.5; }

/// Number 0 takes no room.
void writeArray(std::span<const std::uint32_t> blocks, FunctionRef<void(std::uint32_t)> put) {
  writeOctantArray(blocks.subspan(kIndexedWords), put);
}

constexpr ArrayForm kArray = {
    .words = octantArrayWords, .block = block, .write = writeArray, .byNumber = true};

std::vector<SlotConstant> constants(const Stratum &stratum) {
  return {{"ARRAY_HEAD", static_cast<std::uint32_t>(stratum.arrayHead)}};
}

constexpr std::array<std::string_view, 1> kFiles = {"octants"};
std::span<const std::string_view> files(const Stratum &) { return kFiles; }

} // namespace

extern const SlotKind kOctantSlots = {.name = "octants",
                                      .summary = "a byte of octants, then one of cells for each not empty",
                                      .accessor = files,
                                      .construct = {"voxc_octant_grid.h", "OctantGrid"},
                                      .forbidsEdits = kFixedArray,
                                      .constants = constants,
                                      .array = &kArray,
                                      .hasChildMask = true,
                                      .ranks = true,
                                      .region = region,
                                      .cost = {.words = wordsRead, .factor = kCost},
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
