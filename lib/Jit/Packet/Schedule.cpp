#include "Schedule.h"

#include <llvm/ADT/PostOrderIterator.h>
#include <llvm/IR/CFG.h>
#include <llvm/IR/Instructions.h>

#include <algorithm>

namespace voxc {
namespace {

/// Instructions that cost as much as a branch that is predicted wrongly now and then.
constexpr std::size_t kSkippedInstructions = 24;

} // namespace

Schedule::Schedule(llvm::Function &function) {
  dominators_.recalculate(function);
  postDominators_.recalculate(function);
  loops_.analyze(dominators_);
  const llvm::ReversePostOrderTraversal<llvm::Function *> order(&function);
  for (const llvm::BasicBlock *block : order)
    numbers_[block] = static_cast<unsigned>(numbers_.size());
}

void Schedule::sort(llvm::SmallVectorImpl<llvm::BasicBlock *> &blocks) const {
  std::ranges::sort(blocks, {}, [&](const llvm::BasicBlock *block) { return numbers_.lookup(block); });
}

Schedule::Children Schedule::children(llvm::BasicBlock *block) const {
  Children children;
  const llvm::Loop *loop = loopOf(block);
  for (const llvm::DomTreeNode *child : *dominators_.getNode(block)) {
    const bool stays = loop == nullptr || loop->contains(child->getBlock());
    (stays ? children.within : children.behind).push_back(child->getBlock());
  }
  sort(children.within);
  sort(children.behind);
  return children;
}

llvm::Loop *Schedule::loopAt(const llvm::BasicBlock *block) const {
  llvm::Loop *loop = loopOf(block);
  return loop != nullptr && loop->getHeader() == block ? loop : nullptr;
}

llvm::BasicBlock *Schedule::equivalent(llvm::BasicBlock *block) const {
  const llvm::DomTreeNode *node = dominators_.getNode(block)->getIDom();
  if (node == nullptr || loopAt(block) != nullptr)
    return nullptr;
  llvm::BasicBlock *above = node->getBlock();
  const llvm::Loop *loop = loopOf(block);
  if (loopOf(above) != loop || !postDominators_.dominates(block, above))
    return nullptr;
  if (loop == nullptr)
    return above;
  // In this very turn of the loop: no way leads past the block to the next turn, or out.
  llvm::SmallVector<llvm::BasicBlock *, 8> ends;
  loop->getExitingBlocks(ends);
  const bool leadsPast = std::ranges::any_of(ends, [&](llvm::BasicBlock *end) {
    return !dominators_.properlyDominates(end, above) && !dominators_.dominates(block, end);
  });
  return leadsPast || !dominators_.dominates(block, loop->getLoopLatch()) ? nullptr : above;
}

bool Schedule::isWorthSkipping(llvm::BasicBlock *block) const {
  llvm::SmallVector<llvm::BasicBlock *, 16> blocks;
  dominators_.getDescendants(block, blocks);
  std::size_t count = 0;
  for (const llvm::BasicBlock *inner : blocks) {
    if (loopAt(inner) != nullptr)
      return true;
    for (const llvm::Instruction &instruction : *inner)
      if (llvm::isa<llvm::LoadInst, llvm::StoreInst>(instruction))
        return true;
    count += inner->size();
  }
  return count >= kSkippedInstructions;
}

} // namespace voxc
