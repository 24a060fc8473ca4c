// Building the tree of empty cells, level by level, and descending in it.
#include "OccupancyTree.h"

#include <algorithm>
#include <cstddef>

namespace voxc {

namespace {

constexpr unsigned kChildren = 64;

/// The number of the child that holds `cell` in a node whose children have sides of 2^shift.
unsigned childOf(Int3 cell, int shift) {
  const auto spread = [shift](std::int32_t coordinate) {
    const auto two = static_cast<unsigned>(coordinate >> shift);
    return (two & 1) | (two & 2) << 2;
  };
  return spread(cell.x) | spread(cell.y) << 1 | spread(cell.z) << 2;
}

/// std::popcount is a call where the instruction cannot be taken for granted.
constexpr unsigned countBits(std::uint64_t bits) {
  bits -= bits >> 1 & 0x5555555555555555;
  bits = (bits & 0x3333333333333333) + (bits >> 2 & 0x3333333333333333);
  bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0f;
  return static_cast<unsigned>(bits * 0x0101010101010101 >> 56);
}

/// What a range of cells in Morton order is made of.
struct CodeRange {
  bool occupied;
  bool mixed;
};

/// Answers for ranges that come in order. Codes behind the last change may wrap: all is empty there.
class RangeReader {
public:
  explicit RangeReader(std::span<const std::uint64_t> changes) : changes_(changes) {}

  CodeRange read(std::uint64_t begin, std::uint64_t end) {
    while (next_ < changes_.size() && changes_[next_] <= begin)
      ++next_;
    const bool mixed = next_ < changes_.size() && changes_[next_] < end;
    return {mixed || next_ % 2 == 1, mixed};
  }

private:
  std::span<const std::uint64_t> changes_;
  std::size_t next_ = 0;
};

} // namespace

OccupancyTree::OccupancyTree(std::span<const std::uint64_t> changes, int log2Side)
    : log2Side_(std::max(2, log2Side + log2Side % 2)) {
  std::vector<std::uint64_t> codes{0}, codesBelow; // Where the nodes of a level, and of the next, begin.
  std::size_t first = 0;
  for (int shift = log2Side_ - 2; shift >= 0; shift -= 2) {
    RangeReader reader(changes);
    const std::uint64_t cells = std::uint64_t{1} << 3 * shift;
    codesBelow.clear();
    for (std::size_t i = 0; i < codes.size(); ++i) {
      Node node{0, 0, first + codes.size() + codesBelow.size()};
      for (unsigned child = 0; child < kChildren; ++child) {
        const std::uint64_t code = codes[i] + child * cells;
        const CodeRange range = reader.read(code, code + cells);
        node.occupied |= std::uint64_t{range.occupied} << child;
        node.mixed |= std::uint64_t{range.mixed} << child;
        if (range.mixed)
          codesBelow.push_back(code);
      }
      nodes_[first + i] = node;
    }
    first += codes.size();
    codes.swap(codesBelow);
    nodes_.resize(first + codes.size());
  }
}

std::optional<int> OccupancyTree::emptyAround(Int3 cell) const {
  constexpr unsigned kOctant = 0x38;
  if ((cell.x | cell.y | cell.z) >> log2Side_ != 0)
    return log2Side_;
  const Node *node = nodes_.data();
  for (int shift = log2Side_ - 2;; shift -= 2) {
    const unsigned child = childOf(cell, shift);
    if ((node->occupied >> child & 1) == 0)
      return (node->occupied >> (child & kOctant) & 0xff) == 0 ? shift + 1 : shift;
    const std::uint64_t bit = std::uint64_t{1} << child;
    if ((node->mixed & bit) == 0)
      return std::nullopt;
    node = &nodes_[node->firstChild + countBits(node->mixed & (bit - 1))];
  }
}

} // namespace voxc
