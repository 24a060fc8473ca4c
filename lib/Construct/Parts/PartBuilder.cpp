// Cutting a volume into parts, and building one.
#include "PartBuilder.h"

#include "Construct/Host/SourceHost.h"

#include "Source/CubeTools.h"

#include <algorithm>
#include <bit>

namespace voxc {
namespace {

/// The host of a part: reads a source and keeps the result.
class PartHost final : public SourceHost {
public:
  PartHost(VoxelSource &source, NodeStore &store, VoxelFacts facts, const Progress &progress, bool isEdited,
           Fragment &fragment)
      : SourceHost(source, store, facts, progress, isEdited), fragment_(fragment) {}

protected:
  void putValue(std::uint32_t value) override { fragment_.values.push_back(value); }
  void finishNode(const construct::Node &node) override { fragment_.node = node; }
  void finishCell(const construct::PlacedCell &cell) override { fragment_.cells.push_back(cell); }

private:
  Fragment &fragment_;
};

int log2Ceil(int extent) { return std::bit_width(static_cast<unsigned>(std::max(extent, 1)) - 1); }

} // namespace

PartGrid PartGrid::of(const VoxelSource &source, const Layout &layout) {
  return of(source.extent(), layout, std::max(source.log2Chunk(), construct::kLog2Brick));
}

PartGrid PartGrid::of(Int3 extent, const Layout &layout, int log2Side) {
  PartGrid grid;
  grid.log2Side = layout.partSide(log2Side);
  grid.log2Count = std::max(log2Ceil(maxComponent(extent)) - grid.log2Side, 0);
  return grid;
}

PartGrid PartGrid::upTo(int log2Largest, const Layout &layout) const {
  PartGrid grid = *this;
  for (int side = log2Side + 1; side <= std::min(log2Largest, log2Side + log2Count); ++side)
    if (layout.partSide(side) == side)
      grid.larger |= std::uint32_t{1} << side;
  return grid;
}

std::pair<std::uint64_t, std::uint64_t> PartGrid::range(std::uint64_t fragment,
                                                        std::uint64_t fragments) const {
  // Parts times fragments may be more than 64 bits hold.
  const auto bound = [&](std::uint64_t i) {
    return count() / fragments * i + count() % fragments * i / fragments;
  };
  return {bound(fragment), bound(fragment + 1)};
}

PartSequence::PartSequence(const PartGrid &grid, std::uint64_t begin, std::uint64_t end, Test isEmpty,
                           Test isTooLarge)
    : grid_(grid), begin_(begin), end_(end), isEmpty_(std::move(isEmpty)), isTooLarge_(std::move(isTooLarge)),
      ahead_{{{}, grid.log2Side + grid.log2Count}} {}

bool PartSequence::isPart(const Cube &cube) const {
  if (cube.log2Side == grid_.log2Side)
    return true;
  return grid_.allows(cube.log2Side) && countInRange(cube) == countOf(cube) &&
         !(isTooLarge_ && isTooLarge_(cube));
}

std::uint64_t PartSequence::countOf(const Cube &cube) const {
  return cellCount(cube.log2Side - grid_.log2Side);
}

/// How many of the smallest parts in [begin, end) a cube covers.
std::uint64_t PartSequence::countInRange(const Cube &cube) const {
  const std::uint64_t first = std::max(grid_.index(cube.low), begin_);
  const std::uint64_t last = std::min(grid_.index(cube.low) + countOf(cube), end_);
  return last > first ? last - first : 0;
}

std::optional<Cube> PartSequence::next() {
  while (!ahead_.empty()) {
    const Cube cube = ahead_.back();
    ahead_.pop_back();
    const std::uint64_t count = countInRange(cube);
    if (count == 0)
      continue;
    if (isEmpty_(cube)) {
      looked_ += count;
      continue;
    }
    if (isPart(cube)) {
      looked_ += count;
      return cube;
    }
    const int log2Side = cube.log2Side - 1;
    for (int child = 8; child-- > 0;)
      ahead_.push_back({cube.low + Int3{child & 1, child >> 1 & 1, child >> 2} * (1 << log2Side), log2Side});
  }
  return std::nullopt;
}

void keepWords(NodeStore &store, Fragment &fragment) {
  const auto words = store.words().span();
  fragment.words.assign(words.begin(), words.end());
  fragment.array.assign(store.array().begin(), store.array().end());
}

Expected<PartBuilder> PartBuilder::create(std::unique_ptr<VoxelSource> source, const ConstructCode &code,
                                          const Layout &layout, const std::shared_ptr<WorkingMemory> &memory,
                                          bool isEdited) {
  auto words = VOXC_TRY(WordStore::create(memory));
  auto store = std::make_unique<NodeStore>(std::move(words), layout.countingWords(), memory);
  return PartBuilder(std::move(source), code, layout.voxelFacts(), std::move(store), isEdited);
}

Expected<Fragment> PartBuilder::build(const Cube &cube, const Progress &progress) {
  Fragment fragment;
  fragment.cube = cube;
  store_->clear();
  store_->logTo(&fragment.blocks);
  PartHost host(*source_, *store_, facts_, progress, isEdited_, fragment);
  VOXC_TRY(code_.part(host, cube));
  keepWords(*store_, fragment);
  fragment.voxels = host.voxels();
  fragment.colour = host.colour();
  return fragment;
}

} // namespace voxc
