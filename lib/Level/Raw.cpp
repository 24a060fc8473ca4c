// R: a raw grid. Cell (x, y, z) is the word at x + W * (y + H * z).
#include "Kinds.h"

namespace voxc {
namespace {

constexpr std::array<ParameterKind, 3> kParameters = {{
    {"W", ParameterRole::Width, "log2 of the cells along x"},
    {"H", ParameterRole::Height, "log2 of the cells along y"},
    {"D", ParameterRole::Depth, "log2 of the cells along z"},
}};

constexpr std::array<const AttributeKind *, 1> kAttributes = {&kShareAttribute};

Lookup lookup(const WordReader &words, const Level &level, std::uint32_t offset, Int3 cell) {
  return {words[offset + cellIndex(level.log2Size(), cell)], 0};
}

void walk(WordReader &words, const Level &level, std::uint32_t offset, SubVolumeVisitor &visitor) {
  const Int3 size = level.log2Size();
  const int longest = std::max({size.x, size.y, size.z});
  if (!visitor.enterNode(offset, longest) ||
      !words.require(offset, std::uint64_t{1} << (size.x + size.y + size.z), "a raw grid"))
    return;
  forEachCell(size, {}, longest, [&](Int3 cell) {
    const std::uint32_t value = words[offset + cellIndex(size, cell)];
    if (value != 0 && !visitor.done())
      visitor.cells({cell, 0}, value);
  });
  visitor.leaveNode();
}

bool relocate(std::span<std::uint32_t> words, bool holdsVoxels, std::span<const std::uint32_t> newOffsets) {
  return relocateCells(words, 1, holdsVoxels, newOffsets);
}

} // namespace

const LevelKind kRaw = {'R',
                        "raw",
                        "Raw",
                        "a grid of cells: no compression, the fastest lookup",
                        Arrangement::Grid,
                        1,
                        kParameters,
                        kAttributes,
                        lookup,
                        walk,
                        relocate};

} // namespace voxc
