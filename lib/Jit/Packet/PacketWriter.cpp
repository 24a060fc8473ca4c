#include "PacketWriter.h"

#include "Lanes.h"
#include "Schedule.h"

#include <llvm/ADT/MapVector.h>
#include <llvm/ADT/STLExtras.h>
#include <llvm/IR/CFG.h>
#include <llvm/Transforms/Utils/BasicBlockUtils.h>

namespace voxc {
namespace {

using Blocks = llvm::SmallVector<llvm::BasicBlock *, 8>;

/// A way from one block to another: the lanes that go it, and what they bring to the other's phis.
struct Way {
  llvm::Value *mask;
  llvm::SmallVector<llvm::Value *, 4> values;
};

class PacketWriter {
public:
  PacketWriter(llvm::Function &function, unsigned count, const llvm::TargetTransformInfo &target)
      : function_(function), schedule_(function), lanes_(function, count, target),
        builder_(lanes_.builder()) {}

  const llvm::Instruction *write();

private:
  using Edge = std::pair<llvm::BasicBlock *, llvm::BasicBlock *>;

  llvm::BasicBlock *newBlock(const llvm::Twine &name) {
    return llvm::BasicBlock::Create(function_.getContext(), name, &function_, firstOld_);
  }

  void blocksFrom(llvm::BasicBlock *block, Blocks &behind);
  void skippable(llvm::BasicBlock *block, llvm::Value *mask, Blocks &behind);
  void body(llvm::BasicBlock *block, Blocks &behind);
  void loop(llvm::Loop *loop, llvm::Value *mask, Blocks &behind);
  void after(llvm::Loop *loop, llvm::Value *entered, llvm::BasicBlock *head, llvm::BasicBlock *last);
  void straight(llvm::BasicBlock *block, llvm::Value *mask);
  void ends(llvm::BasicBlock *block, llvm::Value *mask);
  void way(llvm::BasicBlock *from, llvm::BasicBlock *to, llvm::Value *mask);
  llvm::Value *maskOf(llvm::BasicBlock *block);
  llvm::Value *chosen(llvm::BasicBlock *block, unsigned phi);
  llvm::PHINode *phi(llvm::Type *type, llvm::BasicBlock *at, const llvm::Twine &name);

  llvm::Function &function_;
  Schedule schedule_;
  Lanes lanes_;
  llvm::IRBuilder<> &builder_;
  llvm::BasicBlock *firstOld_ = nullptr;
  llvm::MapVector<Edge, Way> ways_; ///< Those that are known and whose ends are not written.
  llvm::DenseMap<llvm::BasicBlock *, llvm::Value *> masks_;
  const llvm::Instruction *unknown_ = nullptr;
};

const llvm::Instruction *PacketWriter::write() {
  Blocks old;
  for (llvm::BasicBlock &block : function_)
    old.push_back(&block);
  firstOld_ = old.front();
  builder_.SetInsertPoint(newBlock("packet"));
  Blocks behind;
  masks_[firstOld_] = lanes_.allLanes();
  body(firstOld_, behind);
  builder_.CreateRetVoid();
  if (unknown_ == nullptr) {
    llvm::DeleteDeadBlocks(old);
    return nullptr;
  }
  // What was written is never run; it only has to be well-formed enough to be thrown away with the module.
  return unknown_;
}

/// The lanes that come to a block; all ways to it are known.
llvm::Value *PacketWriter::maskOf(llvm::BasicBlock *block) {
  if (llvm::BasicBlock *same = schedule_.equivalent(block))
    return masks_.lookup(same);
  llvm::Value *mask = nullptr;
  for (llvm::BasicBlock *from :
       llvm::SmallSetVector<llvm::BasicBlock *, 4>(llvm::pred_begin(block), llvm::pred_end(block))) {
    const auto found = ways_.find({from, block});
    if (found != ways_.end())
      mask = mask == nullptr ? found->second.mask : builder_.CreateOr(mask, found->second.mask);
  }
  return mask;
}

/// What the lanes that come to a block have for one of its phis.
llvm::Value *PacketWriter::chosen(llvm::BasicBlock *block, unsigned phi) {
  llvm::Value *result = nullptr;
  for (llvm::BasicBlock *from :
       llvm::SmallSetVector<llvm::BasicBlock *, 4>(llvm::pred_begin(block), llvm::pred_end(block))) {
    const auto found = ways_.find({from, block});
    if (found == ways_.end())
      continue;
    llvm::Value *value = found->second.values[phi];
    if (result == nullptr || llvm::isa<llvm::UndefValue>(result))
      result = value;
    else if (value != result && !llvm::isa<llvm::UndefValue>(value))
      result = builder_.CreateSelect(found->second.mask, lanes_.spread(value), lanes_.spread(result));
  }
  return result;
}

llvm::PHINode *PacketWriter::phi(llvm::Type *type, llvm::BasicBlock *at, const llvm::Twine &name) {
  llvm::IRBuilder<> begin(at, at->begin());
  return begin.CreatePHI(type, 2, name);
}

/// Writes a block and what it alone leads to. Of that, what lies outside of the loop around the block is put
/// off.
void PacketWriter::blocksFrom(llvm::BasicBlock *block, Blocks &behind) {
  llvm::Value *mask = maskOf(block);
  const bool isCertain = schedule_.equivalent(block) != nullptr;
  if (!isCertain && schedule_.isWorthSkipping(block))
    return skippable(block, mask, behind);
  masks_[block] = mask;
  body(block, behind);
}

/// The same, with a branch around it all for when no lane comes there.
void PacketWriter::skippable(llvm::BasicBlock *block, llvm::Value *mask, Blocks &behind) {
  llvm::BasicBlock *before = builder_.GetInsertBlock();
  llvm::BasicBlock *inside = newBlock(block->getName());
  llvm::SmallVector<Edge, 8> earlier;
  for (auto &[edge, ignored] : ways_)
    earlier.push_back(edge);
  llvm::Value *any = lanes_.any(mask);
  builder_.SetInsertPoint(inside);
  masks_[block] = mask;
  body(block, behind);
  llvm::BasicBlock *last = builder_.GetInsertBlock();
  llvm::BasicBlock *next = newBlock("join");
  builder_.CreateBr(next);
  builder_.SetInsertPoint(before);
  builder_.CreateCondBr(any, inside, next);
  builder_.SetInsertPoint(next);
  const auto merged = [&](llvm::Value *value, llvm::Value *otherwise) -> llvm::Value * {
    if (!llvm::isa<llvm::Instruction>(value))
      return value;
    llvm::PHINode *either = phi(value->getType(), next, "");
    either->addIncoming(value, last);
    either->addIncoming(otherwise, before);
    return either;
  };
  for (auto &[edge, way] : ways_) {
    if (llvm::is_contained(earlier, edge))
      continue;
    way.mask = merged(way.mask, lanes_.noLane());
    if (llvm::isa<llvm::Constant>(way.mask)) // Not for those that pass by.
      way.mask = lanes_.noLane() == way.mask ? way.mask : builder_.CreateLogicalAnd(mask, way.mask);
    for (llvm::Value *&value : way.values)
      value = merged(value, llvm::PoisonValue::get(value->getType()));
  }
}

void PacketWriter::body(llvm::BasicBlock *block, Blocks &behind) {
  if (llvm::Loop *inner = schedule_.loopAt(block))
    return loop(inner, masks_.lookup(block), behind);
  straight(block, masks_.lookup(block));
  const Schedule::Children children = schedule_.children(block);
  for (llvm::BasicBlock *child : children.within)
    blocksFrom(child, behind);
  behind.append(children.behind.begin(), children.behind.end());
}

/// A loop turns as long as any lane turns in it.
void PacketWriter::loop(llvm::Loop *loop, llvm::Value *mask, Blocks &behind) {
  llvm::BasicBlock *header = loop->getHeader();
  llvm::BasicBlock *before = builder_.GetInsertBlock();
  llvm::BasicBlock *head = newBlock(header->getName());
  llvm::SmallVector<llvm::Value *, 8> begins;
  unsigned number = 0;
  for (llvm::PHINode &old : header->phis()) {
    (void)old;
    begins.push_back(lanes_.spread(chosen(header, number++)));
  }
  builder_.CreateBr(head);
  builder_.SetInsertPoint(head);
  llvm::PHINode *turning = builder_.CreatePHI(lanes_.maskType(), 2, "turning");
  turning->addIncoming(mask, before);
  llvm::SmallVector<llvm::PHINode *, 8> phis;
  number = 0;
  for (llvm::PHINode &old : header->phis()) {
    phis.push_back(builder_.CreatePHI(lanes_.wide(old.getType()), 2, old.getName()));
    phis.back()->addIncoming(begins[number++], before);
    lanes_.set(&old, phis.back());
  }
  for (llvm::BasicBlock *from : llvm::predecessors(header))
    ways_.erase({from, header});
  masks_[header] = turning;
  straight(header, turning);
  const Schedule::Children children = schedule_.children(header);
  Blocks exits = {children.behind.begin(), children.behind.end()};
  for (llvm::BasicBlock *child : children.within)
    blocksFrom(child, exits);
  // Back to the head.
  const Way back = ways_[{loop->getLoopLatch(), header}];
  ways_.erase({loop->getLoopLatch(), header});
  llvm::BasicBlock *last = builder_.GetInsertBlock();
  for (auto [phi, value] : llvm::zip(phis, back.values))
    phi->addIncoming(lanes_.spread(value), last);
  turning->addIncoming(back.mask, last);
  after(loop, mask, head, last);
  llvm::BasicBlock *next = newBlock("behind");
  builder_.CreateCondBr(lanes_.any(back.mask), head, next);
  builder_.SetInsertPoint(next);
  schedule_.sort(exits);
  const llvm::Loop *outer = loop->getParentLoop();
  for (llvm::BasicBlock *exit : exits) {
    if (outer != nullptr && !outer->contains(exit))
      behind.push_back(exit);
    else
      blocksFrom(exit, behind);
  }
}

/// Keeps what lanes bring out of a loop until the last has left it.
void PacketWriter::after(llvm::Loop *loop, llvm::Value *entered, llvm::BasicBlock *head,
                         llvm::BasicBlock *last) {
  llvm::SmallVector<std::pair<llvm::BasicBlock *, llvm::BasicBlock *>, 4> edges;
  loop->getExitEdges(edges);
  // Each lane that comes in goes out; where there is one way, by that.
  const bool isOnly = edges.size() == 1;
  llvm::BasicBlock *before = *llvm::pred_begin(head);
  const auto kept = [&](llvm::Value *value, llvm::Value *mask, llvm::Value *begin) {
    llvm::PHINode *earlier = phi(value->getType(), head, "kept");
    llvm::Value *now = builder_.CreateSelect(mask, value, earlier);
    earlier->addIncoming(begin, before);
    earlier->addIncoming(now, last);
    return now;
  };
  for (auto [from, to] : edges) {
    const auto found = ways_.find({from, to});
    if (found == ways_.end())
      continue;
    Way &way = found->second;
    llvm::Value *mask = way.mask;
    way.mask = isOnly ? entered : kept(lanes_.allLanes(), mask, lanes_.noLane());
    unsigned number = 0;
    for (llvm::PHINode &phi : to->phis()) {
      const auto *made = llvm::dyn_cast<llvm::Instruction>(phi.getIncomingValueForBlock(from));
      llvm::Value *&value = way.values[number++];
      if (made != nullptr && loop->contains(made)) {
        llvm::Value *wide = lanes_.spread(value);
        value = kept(wide, mask, llvm::PoisonValue::get(wide->getType()));
      }
    }
  }
}

/// The instructions of one block.
void PacketWriter::straight(llvm::BasicBlock *block, llvm::Value *mask) {
  if (schedule_.loopAt(block) == nullptr) {
    unsigned number = 0;
    for (llvm::PHINode &phi : block->phis())
      lanes_.set(&phi, chosen(block, number++));
    for (llvm::BasicBlock *from : llvm::predecessors(block))
      ways_.erase({from, block});
  }
  for (llvm::Instruction &instruction : *block) {
    if (llvm::isa<llvm::PHINode>(instruction) || instruction.isTerminator())
      continue;
    if (!lanes_.write(instruction, mask)) {
      if (unknown_ == nullptr)
        unknown_ = &instruction;
      lanes_.set(&instruction, llvm::PoisonValue::get(instruction.getType()));
    }
  }
  ends(block, mask);
}

void PacketWriter::ends(llvm::BasicBlock *block, llvm::Value *mask) {
  llvm::Instruction *terminator = block->getTerminator();
  if (llvm::isa<llvm::ReturnInst>(terminator)) // Of the block that is written last.
    return;
  auto *branch = llvm::dyn_cast<llvm::BranchInst>(terminator);
  if (branch == nullptr) {
    if (!llvm::isa<llvm::UnreachableInst>(terminator) && unknown_ == nullptr)
      unknown_ = terminator;
    return;
  }
  if (branch->isUnconditional() || branch->getSuccessor(0) == branch->getSuccessor(1))
    return way(block, branch->getSuccessor(0), mask);
  llvm::Value *condition = lanes_.vector(branch->getCondition());
  // Lanes that are not at work may hold anything, poison too: it must not reach a mask.
  way(block, branch->getSuccessor(0), builder_.CreateLogicalAnd(mask, condition));
  way(block, branch->getSuccessor(1), builder_.CreateLogicalAnd(mask, builder_.CreateNot(condition)));
}

void PacketWriter::way(llvm::BasicBlock *from, llvm::BasicBlock *to, llvm::Value *mask) {
  Way &way = ways_[{from, to}];
  way.mask = mask;
  way.values.clear();
  for (llvm::PHINode &phi : to->phis())
    way.values.push_back(lanes_.get(phi.getIncomingValueForBlock(from)));
}

} // namespace

const llvm::Instruction *writePacket(llvm::Function &function, unsigned lanes,
                                     const llvm::TargetTransformInfo &target) {
  return PacketWriter(function, lanes, target).write();
}

} // namespace voxc
