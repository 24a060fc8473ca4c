// The cells of a flooded tree that make a set.
#include "Source/Interior/FloodTree.h"

#include "Source/CubeTools.h"

#include <algorithm>

namespace voxc {

namespace {

bool areAll(const CellSet::Node &node, std::uint32_t value) {
  return std::ranges::all_of(node, [value](std::uint32_t child) { return child == value; });
}

} // namespace

Expected<FloodTree::Chosen> FloodTree::choose(Choice choice) const {
  auto cells = std::make_shared<CellSet>(memory_);
  Chosen chosen;
  std::optional<Error> error;
  cells->finish(chooseChild(root_, height_, choice, *cells, chosen.count, error), height_);
  if (error)
    return *error;
  chosen.cells = std::move(cells);
  return chosen;
}

/// What a child is in the set; counts what is to be counted of it.
std::uint32_t FloodTree::chooseChild(std::uint32_t child, int height, Choice choice, CellSet &cells,
                                     std::uint64_t &count, std::optional<Error> &error) const {
  const bool areVoxelsCounted = choice == Choice::UnreachedAndVoxels;
  if (child < kFirst) {
    const bool isChosen = child == kReached ? choice == Choice::Reached
                          : child == kEmpty ? choice != Choice::Reached
                                            : areVoxelsCounted;
    if (isChosen && areVoxelsCounted == (child == kFull))
      count += cellCount(3 * height);
    return isChosen ? CellSet::kAll : CellSet::kNone;
  }
  const auto take = [&](const auto &made) -> std::uint32_t {
    if (auto added = cells.add(made))
      return *added;
    else
      error = added.error();
    return CellSet::kNone;
  };
  if (height == 1) {
    const Leaf &leaf = leaves_[child - kFirst];
    Slices chosen;
    for (std::size_t z = 0; z < 8; ++z) {
      const std::uint64_t voxels = leaf.voxels[z];
      chosen[z] = choice == Choice::Reached ? leaf.touched[z] & ~voxels : ~leaf.touched[z];
      if (choice == Choice::Unreached)
        chosen[z] &= ~voxels;
      count += static_cast<std::uint64_t>(std::popcount(areVoxelsCounted ? chosen[z] & voxels : chosen[z]));
    }
    const std::uint64_t bits = countBits(chosen);
    if (bits == 0 || bits == 512)
      return bits == 0 ? CellSet::kNone : CellSet::kAll;
    return take(toMorton(chosen));
  }
  Node children;
  for (std::size_t i = 0; i < children.size() && !error; ++i)
    children[i] = chooseChild(nodes_[child - kFirst][i], height - 1, choice, cells, count, error);
  for (const std::uint32_t whole : {CellSet::kNone, CellSet::kAll})
    if (areAll(children, whole))
      return whole;
  return error ? std::uint32_t{CellSet::kNone} : take(children);
}

Expected<ScratchArray<BrickCells>> FloodTree::voxels() const {
  ScratchArray<BrickCells> bricks(memory_);
  std::optional<Error> error;
  listVoxels(root_, {{}, 3 * height_}, height_, bricks, error);
  if (error)
    return *error;
  return bricks;
}

void FloodTree::listVoxels(std::uint32_t child, const Cube &cube, int height,
                           ScratchArray<BrickCells> &bricks, std::optional<Error> &error) const {
  if (child == kEmpty || child == kReached || error || isOutside(cube, extent_))
    return;
  if (height > 1) {
    const int log2Child = 3 * (height - 1);
    for (std::uint32_t i = 0; i < 512; ++i) {
      const Cube part{cube.low + mortonCell(i) * (1 << log2Child), log2Child};
      listVoxels(child == kFull ? std::uint32_t{kFull} : nodes_[child - kFirst][i], part, height - 1, bricks,
                 error);
    }
    return;
  }
  Slices cells;
  cells.fill(~std::uint64_t{0});
  if (child != kFull)
    cells = leaves_[child - kFirst].voxels;
  // What lies beyond the extent may be taken for full.
  const Slices within = cellsBetween(Int3{} - cube.low, extent_ - cube.low);
  for (std::size_t z = 0; z < cells.size(); ++z)
    cells[z] &= within[z];
  if (!isAny(cells))
    return;
  if (auto added = bricks.push({cube.low, cells}); !added)
    error = added.error();
}

} // namespace voxc
