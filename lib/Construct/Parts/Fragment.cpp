// Joining fragments: the blocks of one after the other, each with its pointers moved.
#include "Fragment.h"

#include "voxc/Layout/SubVolume.h"

#include <algorithm>

namespace voxc {

namespace {

/// Enough to hide the way to memory; more and the first is forgotten before it is used.
constexpr std::size_t kMostWaiting = 32;
/// Blocks ahead of the one that is put, of which single leaves are fetched.
constexpr std::size_t kLeavesAhead = 24;

Error contradiction() { return Error::input("a fragment is broken: it has a pointer that leads nowhere"); }

} // namespace

bool Splice::isIndexed(const BlockRecord &block) const { return layout_.strata[block.level - 1].inArray(); }

/// Most blocks are looked for in tables that are far larger than what is near the processor. So some wait
/// until the way to all of them was fetched. One that points to another that waits ends the waiting; most
/// point to single leaves, which therefore do not wait if they are known.
void Splice::put(std::span<std::uint32_t> words, const BlockRecord &block, std::uint64_t place) {
  const std::size_t index = block.level - 1;
  const bool isLeaf = block.kind == BlockRecord::InternLeaf;
  // A block points only to what was written before it: the offsets from here on are still 0.
  const auto &moved = layout_.leadsIntoArray(index) ? newNumbers_ : newOffsets_;
  const auto relocation = [&](Ref ref) {
    const Ref place = ref & placeMask_;
    if (place >= moved.size())
      return Ref{0};
    if (moved[place] == 0)
      writeWaiting();
    return moved[place] == 0 ? Ref{0} : moved[place] | (ref & ~placeMask_);
  };
  if ((isIndexed(block) && words.size() != kIndexedWords) ||
      !relocate(words, layout_.strata[index], isLeaf ? Block::Leaf : Block::Node, layout_.holdsVoxels(index),
                relocation))
    return store_.fail(contradiction());
  // What is known is not written, so that its order among those that wait does not matter.
  if (isLeaf)
    if (const auto known = store_.knownLeaf(block.level, words[0])) {
      newPlace(block, place) = *known;
      return;
    }
  const bool isSought = block.kind == BlockRecord::Intern;
  waiting_.push_back({block, words, place, isSought ? store_.fetch(block.level, words) : 0});
  if (waiting_.size() == kMostWaiting)
    writeWaiting();
}

void Splice::writeWaiting() {
  for (const Waiting &waiting : waiting_)
    if (waiting.block.kind == BlockRecord::Intern)
      store_.fetchNode(waiting.block.level, waiting.hash);
  for (const Waiting &waiting : waiting_)
    newPlace(waiting.block, waiting.place) = write(waiting);
  waiting_.clear();
}

/// Returns where the block is now.
Ref Splice::write(const Waiting &waiting) {
  const auto &[block, words, place, hash] = waiting;
  return block.kind == BlockRecord::InternLeaf ? store_.internLeaf(block.level, words[0])
         : block.kind == BlockRecord::Intern   ? store_.intern(block.level, words, hash)
                                               : store_.append(block.level, words);
}

void Splice::relocateResult(Fragment &fragment, std::size_t index) {
  const bool holdsVoxels = layout_.holdsVoxels(index);
  const auto &moved = layout_.leadsIntoArray(index) ? newNumbers_ : newOffsets_;
  const auto relocate = [&](std::uint32_t &value) {
    const Ref place = value & placeMask_;
    if (place >= moved.size() || moved[place] == 0)
      return store_.fail(contradiction());
    value = moved[place] | (value & ~placeMask_);
  };
  if (fragment.node.kind == construct::Node::Inner ||
      (fragment.node.kind == construct::Node::Leaf && !holdsVoxels))
    relocate(fragment.node.value);
  if (!holdsVoxels)
    for (construct::PlacedCell &cell : fragment.cells)
      relocate(cell.value);
}

/// Brings near what single leaves some blocks ahead will be looked for by.
void Splice::fetchLeaves(const Fragment &fragment, std::size_t endBlock) {
  for (; ahead_.block < std::min(endBlock, fragment.blocks.size()); ++ahead_.block) {
    const BlockRecord &block = fragment.blocks[ahead_.block];
    if (block.kind == BlockRecord::Forget || isIndexed(block))
      continue;
    if (block.kind == BlockRecord::InternLeaf)
      store_.fetchLeaf(block.level, fragment.words[ahead_.at]);
    ahead_.at += block.words;
  }
}

void Splice::join(Fragment &fragment) {
  newOffsets_.assign(fragment.words.size(), 0);
  newNumbers_ = {0};
  waiting_.clear();
  ahead_ = {};
  std::uint64_t at = 1;
  for (std::size_t i = 0; i < fragment.blocks.size(); ++i) {
    const BlockRecord &block = fragment.blocks[i];
    fetchLeaves(fragment, i + kLeavesAhead);
    if (block.kind == BlockRecord::Forget) {
      writeWaiting();
      store_.forget(block.level);
    } else if (isIndexed(block)) {
      const std::uint64_t number = newNumbers_.size();
      newNumbers_.push_back(0);
      put(std::span(fragment.array).subspan(number * kIndexedWords, block.words), block, number);
    } else {
      put(std::span(fragment.words).subspan(at, block.words), block, at);
      at += block.words;
    }
  }
  writeWaiting();
  relocateResult(fragment, layout_.stratumOfPart(fragment.cube.log2Side));
}

} // namespace voxc
