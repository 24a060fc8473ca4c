// The order in which a packet goes through the blocks of a function, one after the other.
#pragma once

#include <llvm/ADT/ArrayRef.h>
#include <llvm/ADT/DenseMap.h>
#include <llvm/ADT/SmallVector.h>
#include <llvm/Analysis/LoopInfo.h>
#include <llvm/Analysis/PostDominators.h>
#include <llvm/IR/Dominators.h>

namespace voxc {

/// A topological order of blocks in which those of a loop stand together, and after each block those that it
/// alone leads to. That is the dominator tree, whose children stand in reverse post-order, those that leave a
/// loop behind it.
class Schedule {
public:
  explicit Schedule(llvm::Function &function);

  /// What follows a block within the innermost loop around it, and what it leads to outside of that.
  struct Children {
    llvm::SmallVector<llvm::BasicBlock *, 4> within;
    llvm::SmallVector<llvm::BasicBlock *, 4> behind;
  };
  Children children(llvm::BasicBlock *block) const;
  void sort(llvm::SmallVectorImpl<llvm::BasicBlock *> &blocks) const;

  llvm::Loop *loopOf(const llvm::BasicBlock *block) const { return loops_.getLoopFor(block); }
  /// The loop that begins with a block; null if none does.
  llvm::Loop *loopAt(const llvm::BasicBlock *block) const;
  /// The block that is passed by just the lanes that pass this one, where that is known; else null.
  llvm::BasicBlock *equivalent(llvm::BasicBlock *block) const;
  /// True if a block and those it alone leads to are worth a branch around them when no lane takes them.
  bool isWorthSkipping(llvm::BasicBlock *block) const;

private:
  llvm::DominatorTree dominators_;
  llvm::PostDominatorTree postDominators_;
  llvm::LoopInfo loops_;
  llvm::DenseMap<const llvm::BasicBlock *, unsigned> numbers_; ///< In reverse post-order.
};

} // namespace voxc
