// Asking a set of cells.
#include "Source/Interior/CellSet.h"

#include "Source/CubeTools.h"

#include <algorithm>

namespace voxc {

namespace {

/// The number of a cube among those of its size in one of 8^3 of them.
std::uint64_t placeIn(const Cube &cube, int log2Child) { return mortonCode(cube.low >> log2Child) & 511; }

/// The part of a leaf that a cube of at most 8^3 is: its first bit, and how many there are.
struct BitRange {
  std::uint64_t first;
  std::uint64_t count;
};

BitRange rangeOf(const Cube &cube) { return {placeIn(cube, 0), cellCount(cube.log2Side)}; }

} // namespace

Expected<std::uint32_t> CellSet::add(const Node &children) {
  VOXC_TRY(nodes_.push(children));
  memory_->relieve(sizeof children);
  return static_cast<std::uint32_t>(nodes_.size() - 1 + kFirst);
}

Expected<std::uint32_t> CellSet::add(const MortonBits &cells) {
  VOXC_TRY(leaves_.push(cells));
  memory_->relieve(sizeof cells);
  return static_cast<std::uint32_t>(leaves_.size() - 1 + kFirst);
}

CellSet::Place CellSet::find(const Cube &cube) const {
  Place place{root_, height_};
  if (isOutside(cube, Int3{1, 1, 1} * (1 << std::min(3 * height_, kMaxLog2Extent))))
    return {kNone, 0};
  // A cube that is larger than a child ends at the node.
  while (place.child >= kFirst && place.height > 1 && cube.log2Side <= 3 * (place.height - 1)) {
    const Node &node = nodes_[place.child - kFirst];
    --place.height;
    place.child = node[placeIn(cube, 3 * place.height)];
  }
  return place;
}

bool CellSet::is(const Cube &cube, std::uint32_t whole) const {
  const Place place = find(cube);
  if (place.child < kFirst)
    return place.child == whole;
  memory_->relieve(64);
  if (place.height == 1 && cube.log2Side <= kLog2Brick) {
    const auto [first, count] = rangeOf(cube);
    const MortonBits &cells = leaves_[place.child - kFirst];
    for (std::uint64_t i = first; i < first + count; ++i)
      if ((cells[i / 64] >> i % 64 & 1) != whole)
        return false;
    return true;
  }
  if (place.height == 1)
    return false;
  const int log2Child = 3 * (place.height - 1);
  const Node &node = nodes_[place.child - kFirst];
  const auto first = node.begin() + static_cast<std::ptrdiff_t>(placeIn(cube, log2Child));
  const std::uint64_t count = cellCount(std::min(cube.log2Side - log2Child, kLog2Brick));
  return std::all_of(first, first + static_cast<std::ptrdiff_t>(count),
                     [whole](std::uint32_t child) { return child == whole; });
}

void CellSet::paint(const Cube &cube, std::uint32_t word, std::uint32_t *words) const {
  const Place place = find(cube);
  const auto [first, count] = rangeOf(cube);
  if (place.child == kNone)
    return;
  if (place.child == kAll) {
    std::fill_n(words, count, word);
    return;
  }
  memory_->relieve(64);
  const MortonBits &cells = leaves_[place.child - kFirst];
  for (std::uint64_t i = 0; i < count; ++i)
    if ((cells[(first + i) / 64] >> (first + i) % 64 & 1) != 0)
      words[i] = word;
}

} // namespace voxc
