// What a flooded tree is made of, and what is made of it: reading voxels, and choosing cells.
#include "Source/Interior/FloodTree.h"

#include "Source/CubeTools.h"

#include <algorithm>

namespace voxc {

namespace {

bool isInside(const Cube &cube, Int3 extent) {
  for (int axis = 0; axis < 3; ++axis)
    if (cube.low[axis] + cube.side() > extent[axis])
      return false;
  return true;
}

/// Is `value` what all children are?
bool areAll(const CellSet::Node &node, std::uint32_t value) {
  return std::ranges::all_of(node, [value](std::uint32_t child) { return child == value; });
}

} // namespace

Expected<FloodTree> FloodTree::read(VoxelSource &source, Step step, Beyond beyond,
                                    const std::shared_ptr<WorkingMemory> &memory, const Progress &progress) {
  FloodTree tree(step, beyond, memory, progress);
  tree.extent_ = source.extent();
  while (1 << 3 * tree.height_ < std::max({tree.extent_.x, tree.extent_.y, tree.extent_.z}))
    ++tree.height_;
  if (!tree.isWhole(source, {{}, 3 * tree.height_}, tree.root_))
    tree.root_ = tree.readCube(source, {}, tree.height_);
  if (!tree.error_)
    tree.error_ = source.failure();
  if (tree.error_)
    return *tree.error_;
  return tree;
}

/// Is a cube known to be empty or full before its voxels are read? Then `child` is set.
bool FloodTree::isWhole(VoxelSource &source, const Cube &cube, std::uint32_t &child) const {
  const bool isBeyond = beyond_ == Beyond::Solid && isOutside(cube, extent_);
  child = isBeyond ? kFull : kEmpty;
  return isBeyond || ((beyond_ == Beyond::Empty || isInside(cube, extent_)) && source.empty(cube));
}

std::uint32_t FloodTree::readCube(VoxelSource &source, Int3 low, int height) {
  if (height == 1)
    return readBrick(source, low);
  const std::uint32_t child = addNode(kEmpty);
  if (error_)
    return kEmpty;
  readChildren(source, {low, 3 * height}, child - kFirst, height);
  for (const std::uint32_t whole : {kEmpty, kFull})
    if (areAll(nodes_[child - kFirst], whole)) {
      // It has no nodes below it, so it is the last one.
      check(nodes_.resize(nodes_.size() - 1));
      return whole;
    }
  return child;
}

/// Reads the octants of `cube`, a part of a node, down to the node's children.
void FloodTree::readChildren(VoxelSource &source, const Cube &cube, std::uint32_t node, int height) {
  const int half = cube.log2Side - 1;
  const int log2Child = 3 * (height - 1);
  for (unsigned octant = 0; octant < 8 && !isStopped(); ++octant) {
    const Cube part{cube.low + mortonCell(octant) * (1 << half), half};
    std::uint32_t child = kEmpty;
    const bool whole = isWhole(source, part, child);
    if (!whole && half > log2Child) {
      readChildren(source, part, node, height);
      continue;
    }
    if (!whole)
      child = readCube(source, part.low, height - 1);
    const std::uint64_t place = mortonCode(part.low >> log2Child) & 511;
    std::fill_n(nodes_[node].begin() + static_cast<std::ptrdiff_t>(place), cellCount(half - log2Child),
                child);
  }
}

std::uint32_t FloodTree::readBrick(VoxelSource &source, Int3 low) {
  std::array<std::uint32_t, 512> words;
  const Cube cube{low, CellSet::kLog2Brick};
  source.read(cube, words.data());
  if (beyond_ == Beyond::Solid && !isInside(cube, extent_))
    forEachCell(cube, [&](std::uint64_t index, Int3 cell) {
      if (!contains(extent_, cell))
        words[index] = 1;
    });
  const MortonBits bits = bitsOf(words.data());
  const std::uint64_t count = countBits(bits);
  if (count == 0 || count == words.size())
    return count == 0 ? kEmpty : kFull;
  if (auto error = source.failure())
    check(*error);
  progress_.at("find the inside",
               static_cast<double>(mortonCode(low)) / static_cast<double>(cellCount(3 * height_)));
  return addLeaf(low, toSlices(bits));
}

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
  const bool areVoxelsCounted = choice == Choice::DryAndVoxels;
  if (child < kFirst) {
    const bool isChosen = child == kWet     ? choice == Choice::Reached
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
      if (choice == Choice::Dry)
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

} // namespace voxc
