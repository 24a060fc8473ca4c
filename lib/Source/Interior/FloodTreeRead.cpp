// Reading voxels into a tree: alone, or chunk by chunk on several threads.
#include "Source/Interior/FloodTree.h"

#include "Source/CubeTools.h"
#include "Support/ParallelFor.h"

#include <algorithm>
#include <atomic>
#include <mutex>

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

Expected<FloodTree> FloodTree::read(VoxelSource &source, const Flood &flood, const InteriorOptions &options) {
  FloodTree tree(flood, options.memory, options.progress);
  tree.extent_ = source.extent();
  while (1 << 3 * tree.height_ < std::max({tree.extent_.x, tree.extent_.y, tree.extent_.z}))
    ++tree.height_;
  const bool isAlone = options.threads == 1 || tree.height_ <= kChunkHeight || !source.view();
  ScratchArray<Chunk> chunks(options.memory);
  tree.chunks_ = isAlone ? nullptr : &chunks;
  if (!tree.isWhole(source, {{}, 3 * tree.height_}, tree.root_))
    tree.root_ = tree.readCube(source, {}, tree.height_);
  if (!isAlone)
    tree.readChunks(source, chunks.span(), options.threads);
  tree.chunks_ = nullptr;
  if (tree.error_)
    return *tree.error_;
  return tree;
}

/// Reads what was put off. Where nodes and leaves lie depends on who was first, but nothing that is asked of
/// them.
void FloodTree::readChunks(VoxelSource &source, std::span<const Chunk> chunks, unsigned threads) {
  std::atomic<std::uint64_t> next = 0;
  std::mutex joining;
  parallelFor(threadsOrAll(threads), threads, [&](std::uint64_t) {
    std::unique_ptr<VoxelSource> view;
    {
      const std::lock_guard lock(joining);
      view = source.view();
    }
    FloodTree part({step_, outside_}, memory_, progress_.silent());
    part.extent_ = extent_;
    for (std::uint64_t i = next++; i < chunks.size(); i = next++) {
      const std::uint32_t child = part.readCube(*view, chunks[i].low, kChunkHeight);
      const std::lock_guard lock(joining);
      join(part, child, chunks[i]);
      progress_.at("find the inside", static_cast<double>(i) / static_cast<double>(chunks.size()));
      if (error_)
        return;
    }
  });
}

/// Moves the nodes and leaves of a part to where a chunk was put off. `child` is the chunk's node there, if
/// it is one.
void FloodTree::join(FloodTree &part, std::uint32_t child, const Chunk &chunk) {
  if (part.error_)
    check(*part.error_);
  for (Node &node : part.nodes_.span())
    for (std::uint32_t &leaf : node)
      leaf += leaf < kFirst ? 0 : static_cast<std::uint32_t>(leaves_.size());
  if (child >= kFirst)
    child += static_cast<std::uint32_t>(nodes_.size());
  check(nodes_.append(part.nodes_.span()));
  check(leaves_.append(part.leaves_.span()));
  nodes_[chunk.node][chunk.place] = child;
  check(part.nodes_.resize(0));
  check(part.leaves_.resize(0));
}

/// Is a cube known to be empty or full before its voxels are read? Then `child` is set.
bool FloodTree::isWhole(VoxelSource &source, const Cube &cube, std::uint32_t &child) const {
  const bool isTakenAsFull = outside_ == Outside::Solid && isOutside(cube, extent_);
  child = isTakenAsFull ? kFull : kEmpty;
  return isTakenAsFull || ((outside_ == Outside::Empty || isInside(cube, extent_)) && source.empty(cube));
}

std::uint32_t FloodTree::readCube(VoxelSource &source, Int3 low, int height) {
  if (height == 1)
    return readBrick(source, low);
  const std::uint32_t child = addNode(kEmpty);
  if (error_)
    return kEmpty;
  readChildren(source, {low, 3 * height}, child - kFirst, height);
  // Not all is known where chunks are put off.
  if (chunks_)
    return child;
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
    const std::uint64_t place = mortonCode(part.low >> log2Child) & 511;
    if (!whole && chunks_ && height - 1 == kChunkHeight)
      check(chunks_->push({node, static_cast<std::uint32_t>(place), part.low}));
    else if (!whole)
      child = readCube(source, part.low, height - 1);
    std::fill_n(nodes_[node].begin() + static_cast<std::ptrdiff_t>(place), cellCount(half - log2Child),
                child);
  }
}

std::uint32_t FloodTree::readBrick(VoxelSource &source, Int3 low) {
  std::array<std::uint32_t, 512> words;
  const Cube cube{low, CellSet::kLog2Brick};
  check(source.read(cube, words.data()));
  if (error_)
    return kEmpty;
  if (outside_ == Outside::Solid && !isInside(cube, extent_))
    forEachCell(cube, [&](std::uint64_t index, Int3 cell) {
      if (!contains(extent_, cell))
        words[index] = 1;
    });
  const MortonBits bits = bitsOf(words.data());
  const std::uint64_t count = countBits(bits);
  if (count == 0 || count == words.size())
    return count == 0 ? kEmpty : kFull;
  progress_.at("find the inside",
               static_cast<double>(mortonCode(low)) / static_cast<double>(cellCount(3 * height_)));
  return addLeaf(low, toSlices(bits));
}

} // namespace voxc
