// Going down a sub-volume by its stratum's record.
#include "voxc/Layout/SubVolume.h"
#include "voxc/Layout/Layout.h"

#include "Masks.h"
#include "Places.h"

#include <array>

namespace voxc {
namespace {

/// Visits the nodes of one sub-volume in Morton order and checks each before it is used.
class Visit {
public:
  Visit(WordReader &words, const Stratum &stratum, SubVolumeVisitor &visitor)
      : words_(words), stratum_(stratum), visitor_(visitor) {}

  void subVolume(std::uint64_t offset) {
    if (stratum_.depth == 0)
      leaf(offset, {}, {});
    else
      node(offset, {}, stratum_.depth, {});
  }

private:
  /// The sub-volume that a number leads to.
  void numbered(std::uint32_t value, const Cube &cube, Ranks ranks) {
    if (value == 0)
      words_.fail("an indexed sub-volume has no number");
    else
      visitor_.cells(cube, value, ranks);
  }

  /// The word of a leaf, in a slot that was checked or in a block of its own.
  void leaf(std::uint64_t at, const Cube &cube, Ranks ranks) {
    const std::uint64_t count = stratum_.hasRecords() ? 1 + MaskShape(stratum_).words() : 1;
    if (!stratum_.isGrid() && !words_.require(at, count, "a leaf"))
      return;
    // Nothing may stand where masks say that something does: kernels and lookups would tell it in two ways.
    bool isLeaf = at != 0 && stratum_.cellValue(words_[at]) != 0;
    for (std::uint64_t i = 1; i < count; ++i)
      isLeaf &= words_[at + i] == 0;
    if (!isLeaf)
      words_.fail("a leaf at word " + std::to_string(at) + " is empty or malformed");
    else
      visitor_.cells(cube, stratum_.cellValue(words_[at]), ranks);
  }

  void node(std::uint64_t at, Int3 low, int layer, Ranks ranks) {
    const int log2Side = maxComponent(stratum_.log2Shape) * layer;
    if (visitor_.done())
      return;
    if (!stratum_.isGrid() && visitor_.countsCells(log2Side) && isCounted(at, layer))
      return;
    if (!visitor_.enterNode(at, log2Side, ranks))
      return;
    const SlotKind &slots = *stratum_.slots;
    if (!slots.check(words_, stratum_, at, layer == 1))
      return;
    if (!(layer == 1 && visitor_.countsCells(0) && isCounted(at, layer)))
      children(at, low, layer, ranks);
    visitor_.leaveNode();
  }

  /// True if the visitor has been told the number of a node's cells.
  bool isCounted(std::uint64_t node, int layer) {
    const std::uint64_t count =
        stratum_.slots->count ? stratum_.slots->count(words_, stratum_, node, layer) : 0;
    visitor_.countCells(count);
    return count != 0;
  }

  /// A child of a node, and what it is of its parent.
  struct Place {
    Cube cube;
    Child child;
    Ranks ranks;
  };

  /// Nodes lie anywhere in memory, so the way to some siblings is begun before the first of them is entered.
  void children(std::uint64_t at, Int3 low, int layer, Ranks ranks) {
    const int log2Child = maxComponent(stratum_.log2Shape) * (layer - 1);
    std::array<Place, 8> waiting;
    std::size_t count = 0;
    const auto enterAll = [&] {
      for (std::size_t i = 0; i < count && !visitor_.done(); ++i)
        enter(waiting[i], layer);
      count = 0;
    };
    stratum_.slots->visit(words_, stratum_, at, [&](Int3 place, const Child &child) {
      const Cube cube = {low + place * (1 << log2Child), log2Child};
      waiting[count] = {cube, child, {ranks.first + voxelsBefore(child, log2Child), child.voxels}};
      foresee(waiting[count]);
      if (++count == waiting.size())
        enterAll();
    });
    enterAll();
  }

  void foresee(const Place &place) {
    const Child &child = place.child;
    if (child.leaf && stratum_.implied)
      return;
    if (stratum_.slots->givesCells)
      return visitor_.foreseeCell(child.value);
    if (child.leaf && stratum_.isGrid())
      return visitor_.foreseeCell(stratum_.cellValue(words_[child.at]));
    words_.fetch(beginOf(stratum_, child.at));
    if (!child.leaf)
      visitor_.foreseeNode(child.at, place.cube.log2Side);
  }

  void enter(const Place &place, int layer) {
    const auto &[cube, child, ranks] = place;
    if (child.leaf && stratum_.implied)
      visitor_.cells(cube, kOccupied, ranks);
    else if (stratum_.slots->givesCells)
      numbered(child.value, cube, ranks);
    else if (child.leaf)
      leaf(child.at, cube, ranks);
    else if (layer > 1)
      node(child.at, cube.low, layer - 1, ranks);
  }

  WordReader &words_;
  const Stratum &stratum_;
  SubVolumeVisitor &visitor_;
};

} // namespace

std::uint32_t cellValue(const WordReader &words, const Stratum &stratum, const Child &leaf) {
  return stratum.implied             ? kOccupied
         : stratum.slots->givesCells ? leaf.value
                                     : stratum.cellValue(words[leaf.at]);
}

std::uint64_t voxelsBefore(const Child &child, int log2Child) {
  return child.before + (child.leavesBefore << 3 * log2Child);
}

Ranks ranksInLeaf(const Stratum &stratum, const Child &leaf, int log2Child, Int3 cell) {
  const int inside = (1 << log2Child) - 1;
  const std::uint64_t voxels = stratum.implied ? 1 : leaf.voxels >> 3 * log2Child;
  return {mortonCode({cell.x & inside, cell.y & inside, cell.z & inside}) * voxels, voxels};
}

Lookup lookUp(const WordReader &words, const Stratum &stratum, std::uint64_t offset, Int3 cell) {
  std::uint64_t node = offset;
  std::uint64_t rank = 0;
  const Int3 shape = stratum.log2Shape;
  for (int layer = stratum.depth; layer > 0; --layer) {
    const Int3 place = {cell.x >> shape.x * (layer - 1) & ((1 << shape.x) - 1),
                        cell.y >> shape.y * (layer - 1) & ((1 << shape.y) - 1),
                        cell.z >> shape.z * (layer - 1) & ((1 << shape.z) - 1)};
    const Child child = stratum.slots->child(words, stratum, node, place);
    const int log2Child = maxComponent(shape) * (layer - 1);
    if (!child.exists)
      return {0, log2Child + child.log2Around, rank};
    rank += voxelsBefore(child, log2Child);
    if (child.leaf) {
      rank += ranksInLeaf(stratum, child, log2Child, cell).first;
      return {cellValue(words, stratum, child), log2Child, rank};
    }
    node = child.at;
  }
  return {words[node], 0, rank};
}

void visitSubVolume(WordReader &words, const Stratum &stratum, std::uint64_t offset,
                    SubVolumeVisitor &visitor) {
  Visit(words, stratum, visitor).subVolume(offset);
}

bool relocate(std::span<std::uint32_t> words, const Stratum &stratum, Block block, bool holdsVoxels,
              Relocation relocation) {
  if (block == Block::Leaf)
    return stratum.hasLeafWords() && words.size() == 1 && (holdsVoxels || relocateRef(words[0], relocation));
  return stratum.slots->relocate(words, stratum, holdsVoxels, relocation);
}

} // namespace voxc
