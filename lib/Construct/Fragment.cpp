// Joining fragments: the blocks of one after the other, each with its pointers moved.
#include "Fragment.h"

#include "voxc/Layout/SubVolume.h"

#include <algorithm>

namespace voxc {

namespace {

Error contradiction() { return Error::input("a fragment is broken: it has a pointer that leads nowhere"); }

} // namespace

bool Splice::isIndexed(const BlockRecord &block) const { return layout_.isIndexed(block.level - 1); }

/// Returns where the block is now.
std::uint32_t Splice::write(std::span<std::uint32_t> words, const BlockRecord &block) {
  const std::size_t index = block.level - 1;
  const bool isLeaf = block.kind == BlockRecord::InternLeaf;
  // A block points only to what was written before it: the offsets from here on are still 0.
  const auto &moved = layout_.strata[index].isIndexed() ? newNumbers_ : newOffsets_;
  const auto relocation = [&](Ref ref) { return ref < moved.size() ? moved[ref] : 0; };
  if ((isIndexed(block) && words.size() != kIndexedWords) ||
      !relocate(words, layout_.strata[index], isLeaf ? Block::Leaf : Block::Node, layout_.holdsVoxels(index),
                relocation)) {
    store_.fail(contradiction());
    return 0;
  }
  return isLeaf                              ? store_.internLeaf(block.level, words[0])
         : block.kind == BlockRecord::Intern ? store_.intern(block.level, words)
                                             : store_.append(block.level, words);
}

void Splice::relocateResult(Fragment &fragment, std::size_t index) {
  const bool holdsVoxels = layout_.holdsVoxels(index);
  const auto &moved = layout_.strata[index].isIndexed() ? newNumbers_ : newOffsets_;
  const auto relocate = [&](std::uint32_t &value) {
    value = value < moved.size() ? moved[value] : 0;
    if (value == 0)
      store_.fail(contradiction());
  };
  if (fragment.node.kind == construct::Node::Inner ||
      (fragment.node.kind == construct::Node::Leaf && !holdsVoxels))
    relocate(fragment.node.value);
  if (!holdsVoxels)
    for (construct::PlacedCell &cell : fragment.cells)
      relocate(cell.value);
}

void Splice::join(Fragment &fragment) {
  newOffsets_.assign(fragment.words.size(), 0);
  newNumbers_ = {0};
  std::uint64_t at = 1;
  for (const BlockRecord &block : fragment.blocks) {
    if (block.kind == BlockRecord::Forget) {
      store_.forget(block.level);
    } else if (isIndexed(block)) {
      const std::uint64_t inArray = newNumbers_.size() * kIndexedWords;
      newNumbers_.push_back(write(std::span(fragment.array).subspan(inArray, block.words), block));
    } else {
      newOffsets_[at] = write(std::span(fragment.words).subspan(at, block.words), block);
      at += block.words;
    }
  }
  relocateResult(fragment, layout_.stratumOfPart(fragment.cube.log2Side));
}

} // namespace voxc
