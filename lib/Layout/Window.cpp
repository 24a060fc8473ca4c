// The cells of a sub-volume that lie in a window: the way down to it once, and from there only what is there.
#include "voxc/Layout/SubVolume.h"

#include "Places.h"

#include <algorithm>

namespace voxc {
namespace {

class WindowTraversal {
public:
  WindowTraversal(const WordReader &words, const Stratum &stratum, const Cube &window, WindowVisit visit)
      : words_(words), stratum_(stratum), window_(window), visit_(visit) {}

  /// A node of the layer, whose first cell is `low`, and which the window meets.
  void node(std::uint64_t at, Int3 low, int layer, std::uint64_t rank) {
    const int log2Child = maxComponent(stratum_.log2Shape) * (layer - 1);
    if (log2Child >= window_.log2Side)
      return around(at, low, layer, rank);
    const SlotKind &slots = *stratum_.slots;
    const bool isWhole = maxComponent(stratum_.log2Shape) * layer <= window_.log2Side;
    // Tables are gone through entry by entry, and words that nobody checked may tell of very many.
    if (isWhole && !slots.lookUpLoops)
      return slots.visit(words_, stratum_, at, [&](Int3 place, const Child &child) {
        enter(child, low + place * (1 << log2Child), layer, rank);
      });
    const Int3 first = isWhole ? Int3{} : (window_.low - low) >> log2Child;
    const int log2Side = std::min(window_.log2Side - log2Child, maxComponent(stratum_.log2Shape));
    forEachPlace(stratum_.log2Shape, first, log2Side, [&](Int3 place) {
      if (const Child child = slots.child(words_, stratum_, at, place); child.exists)
        enter(child, low + place * (1 << log2Child), layer, rank);
    });
  }

private:
  /// The one child that the window lies in.
  void around(std::uint64_t at, Int3 low, int layer, std::uint64_t rank) {
    const int log2Child = maxComponent(stratum_.log2Shape) * (layer - 1);
    const Int3 place = (window_.low - low) >> log2Child;
    if (const Child child = stratum_.slots->child(words_, stratum_, at, place); child.exists)
      enter(child, low + place * (1 << log2Child), layer, rank);
  }

  /// A child that is not empty, from `low` on.
  void enter(const Child &child, Int3 low, int layer, std::uint64_t rank) {
    const int log2Child = maxComponent(stratum_.log2Shape) * (layer - 1);
    rank += voxelsBefore(child, log2Child);
    if (!child.leaf)
      return layer > 1 ? node(child.at, low, layer - 1, rank) : cells({low, 0}, words_[child.at], rank, 0);
    // A leaf may be larger than the window.
    const Cube cube{log2Child > window_.log2Side ? window_.low : low, std::min(log2Child, window_.log2Side)};
    const Ranks ranks = ranksInLeaf(stratum_, child, log2Child, cube.low);
    cells(cube, cellValue(words_, stratum_, child), rank + ranks.first, ranks.count);
  }

  void cells(const Cube &cube, std::uint32_t value, std::uint64_t rank, std::uint64_t each) {
    if (value != 0)
      visit_(cube, value, rank, each);
  }

  const WordReader &words_;
  const Stratum &stratum_;
  Cube window_;
  WindowVisit visit_;
};

} // namespace

void visitWindow(const WordReader &words, const Stratum &stratum, std::uint64_t offset, const Cube &window,
                 WindowVisit visit) {
  if (stratum.depth == 0) {
    if (words[offset] != 0)
      visit({{}, 0}, words[offset], 0, 0);
    return;
  }
  WindowTraversal(words, stratum, window, visit).node(offset, {}, stratum.depth, 0);
}

} // namespace voxc
