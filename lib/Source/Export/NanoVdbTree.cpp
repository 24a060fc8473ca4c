// The traversal: cubes of the sizes of NanoVDB's nodes, each a tile if it is of one colour, and else divided.
#include "Source/Export/NanoVdbTree.h"

#include "Source/CubeTools.h"
#include "Source/NanoVdbLayout.h"
#include "voxc/Source/Sources.h"

#include <utility>

namespace voxc {

namespace {

using nanovdb::kLog2Leaf;
using nanovdb::kLog2Lower;
using nanovdb::kLog2Upper;

ActiveBox boxOf(const Cube &cube) {
  const auto last = static_cast<std::int32_t>(cube.side() - 1);
  return {cube.low, cube.low + Int3{last, last, last}};
}

class TreeTraversal {
public:
  TreeTraversal(const Volume &volume, const std::shared_ptr<WorkingMemory> &memory, const Progress &progress)
      : volume_(volume), progress_(progress), tree_(memory),
        source_(makeVolumeSource(std::shared_ptr<const Volume>(std::shared_ptr<void>(), &volume))) {}

  Expected<NanoVdbTree> run() {
    const Int3 extent = volume_.info().extent;
    int log2Side = kLog2Upper;
    while (std::int64_t{1} << log2Side < std::max({extent.x, extent.y, extent.z}))
      ++log2Side;
    VOXC_TRY(traverse({{}, log2Side}));
    return std::move(tree_);
  }

private:
  Expected<void> traverse(const Cube &cube) {
    if (source_->empty(cube))
      return {};
    if (progress_.stopped())
      return Error::interrupted();
    if (cube.log2Side == kLog2Upper)
      return addUpper(cube);
    if (cube.log2Side == kLog2Lower)
      return addLower(cube);
    return cube.log2Side == kLog2Leaf ? addBrick(cube) : divide(cube);
  }

  Expected<void> divide(const Cube &cube) {
    const int half = cube.log2Side - 1;
    for (std::uint64_t child = 0; child < 8; ++child)
      VOXC_TRY(traverse({cube.low + mortonCell(child) * (1 << half), half}));
    return {};
  }

  /// The word of a cube that the volume keeps as one, within its extent; else 0.
  std::uint32_t uniformWord(const Cube &cube) const {
    if (!contains(volume_.info().extent, boxOf(cube).high))
      return 0;
    const Lookup found = volume_.lookup(cube.low);
    return found.log2Side >= cube.log2Side ? found.value : 0;
  }

  Expected<void> addTile(ScratchArray<TreeChild> &list, const Cube &cube, std::uint32_t word,
                         std::size_t level) {
    ++tree_.tiles[level];
    tree_.voxels += cellCount(cube.log2Side);
    tree_.box.add(boxOf(cube));
    return list.push({cube.low, word});
  }

  Expected<void> addUpper(const Cube &cube) {
    if (const std::uint32_t word = uniformWord(cube))
      return addTile(tree_.root, cube, word, 2);
    TreeNode node{cube.low, 0, tree_.ofUppers.size(), tree_.lowers.size(), {}};
    const ActiveBox outer = std::exchange(tree_.box, {});
    VOXC_TRY(divide(cube));
    return close(tree_.uppers, tree_.root, node, tree_.ofUppers.size(), outer);
  }

  Expected<void> addLower(const Cube &cube) {
    if (const std::uint32_t word = uniformWord(cube))
      return addTile(tree_.ofUppers, cube, word, 1);
    TreeNode node{cube.low, 0, tree_.ofLowers.size(), tree_.leaves, {}};
    const ActiveBox outer = std::exchange(tree_.box, {});
    VOXC_TRY(divide(cube));
    return close(tree_.lowers, tree_.ofUppers, node, tree_.ofLowers.size(), outer);
  }

  /// Adds a node whose children are all there, if it has one, and goes on with the box around it.
  Expected<void> close(ScratchArray<TreeNode> &nodes, ScratchArray<TreeChild> &parents, TreeNode &node,
                       std::uint64_t childrenEnd, const ActiveBox &outer) {
    node.box = std::exchange(tree_.box, outer);
    node.children = static_cast<std::uint32_t>(childrenEnd - node.firstChild);
    if (node.children == 0)
      return {};
    tree_.box.add(node.box);
    VOXC_TRY(nodes.push(node));
    return parents.push({node.low, 0});
  }

  Expected<void> addBrick(const Cube &cube) {
    std::array<std::uint32_t, 512> words;
    VOXC_TRY(readBrickWithin(*source_, cube.low, words));
    if (words[0] != 0 && std::ranges::all_of(words, [&](std::uint32_t word) { return word == words[0]; }))
      return addTile(tree_.ofLowers, cube, words[0], 0);
    ActiveBox box;
    std::uint64_t voxels = 0;
    forEachCell(cube, [&](std::uint64_t at, Int3 cell) {
      if (words[at] == 0)
        return;
      ++voxels;
      box.add({cell, cell});
    });
    if (voxels == 0)
      return {};
    tree_.voxels += voxels;
    tree_.box.add(box);
    ++tree_.leaves;
    return tree_.ofLowers.push({cube.low, 0});
  }

  const Volume &volume_;
  const Progress &progress_;
  NanoVdbTree tree_;
  std::unique_ptr<VoxelSource> source_;
};

} // namespace

Expected<void> readBrickWithin(VoxelSource &source, Int3 low, std::array<std::uint32_t, 512> &words) {
  const Cube cube{low, kLog2Leaf};
  VOXC_TRY(source.read(cube, words.data()));
  if (contains(source.extent(), boxOf(cube).high))
    return {};
  forEachCell(cube, [&](std::uint64_t at, Int3 cell) {
    if (!contains(source.extent(), cell))
      words[at] = 0;
  });
  return {};
}

Expected<NanoVdbTree> findNanoVdbTree(const Volume &volume, const std::shared_ptr<WorkingMemory> &memory,
                                      const Progress &progress) {
  return TreeTraversal(volume, memory, progress).run();
}

} // namespace voxc
