// Joining fragments: the blocks of one after the other, each with its pointers moved.
#include "Fragment.h"

#include "voxc/Layout/SubVolume.h"

#include <algorithm>

namespace voxc {

namespace {

Error contradiction() { return Error::input("a fragment is broken: it has a pointer that leads nowhere"); }

} // namespace

void Splice::write(std::span<std::uint32_t> words, std::uint64_t at, const BlockRecord &block) {
  const std::size_t index = block.level - 1;
  const bool isLeaf = block.kind == BlockRecord::InternLeaf;
  // A block points only to what was written before it: the offsets from here on are still 0.
  const auto relocation = [&](Ref ref) { return ref < newOffsets_.size() ? newOffsets_[ref] : 0; };
  if (!relocate(words, layout_.strata[index], isLeaf ? Block::Leaf : Block::Node, layout_.holdsVoxels(index),
                relocation))
    return store_.fail(contradiction());
  newOffsets_[at] = isLeaf                              ? store_.internLeaf(block.level, words[0])
                    : block.kind == BlockRecord::Intern ? store_.intern(block.level, words)
                                                        : store_.append(block.level, words);
}

void Splice::relocateResult(Fragment &fragment, bool holdsVoxels) {
  const auto relocate = [&](std::uint32_t &value) {
    value = value < newOffsets_.size() ? newOffsets_[value] : 0;
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

void Splice::join(Fragment &fragment, int log2Side) {
  newOffsets_.assign(fragment.words.size(), 0);
  std::uint64_t at = 1;
  for (const BlockRecord &block : fragment.blocks) {
    if (block.kind == BlockRecord::Forget)
      store_.forget(block.level);
    else
      write(std::span(fragment.words).subspan(at, block.words), at, block);
    at += block.words;
  }
  relocateResult(fragment, layout_.holdsVoxels(layout_.stratumOfPart(log2Side)));
}

} // namespace voxc
