// D: a grid whose cells carry the L1 distance to the nearest cell that is not empty, so that a ray may step
// over several. Two words a cell: the terminating integer, the distance.
#include "Kinds.h"

namespace voxc {
namespace {

constexpr std::array<ParameterKind, 4> kParameters = {{
    {"W", ParameterRole::Width, "log2 of the cells along x"},
    {"H", ParameterRole::Height, "log2 of the cells along y"},
    {"D", ParameterRole::Depth, "log2 of the cells along z"},
    {"M", ParameterRole::Reach, "the largest distance stored, in cells"},
}};

constexpr std::array<const AttributeKind *, 1> kAttributes = {&kShareAttribute};

Lookup lookup(const WordReader &words, const Level &level, std::uint32_t offset, Int3 cell) {
  return {words[offset + 2 * cellIndex(level.log2Size(), cell)], 0};
}

void checkDistance(WordReader &words, std::uint32_t value, std::uint32_t distance, std::uint32_t reach) {
  if (value != 0 && distance != 0)
    words.fail("a cell of a distance field is not empty but has a distance");
  else if (value == 0 && (distance == 0 || distance > reach))
    words.fail("an empty cell of a distance field has a distance outside 1.." + std::to_string(reach));
}

void walk(WordReader &words, const Level &level, std::uint32_t offset, SubVolumeVisitor &visitor) {
  const Int3 size = level.log2Size();
  const int longest = std::max({size.x, size.y, size.z});
  if (!visitor.enterNode(offset, longest) ||
      !words.require(offset, std::uint64_t{2} << (size.x + size.y + size.z), "a distance field"))
    return;
  const std::uint32_t reach = level.parameter(ParameterRole::Reach);
  forEachCell(size, {}, longest, [&](Int3 cell) {
    const std::uint64_t at = offset + 2 * cellIndex(size, cell);
    checkDistance(words, words[at], words[at + 1], reach);
    if (words[at] != 0 && !visitor.done())
      visitor.cells({cell, 0}, words[at]);
  });
  visitor.leaveNode();
}

bool relocate(std::span<std::uint32_t> words, bool holdsVoxels, std::span<const std::uint32_t> newOffsets) {
  return relocateCells(words, 2, holdsVoxels, newOffsets);
}

} // namespace

const LevelKind kDistance = {'D',
                             "distance",
                             "DF",
                             "a grid with the distance to the nearest full cell: long steps, twice the size",
                             Arrangement::Grid,
                             2,
                             kParameters,
                             kAttributes,
                             lookup,
                             walk,
                             relocate};

} // namespace voxc
