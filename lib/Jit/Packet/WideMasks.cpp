#include "WideMasks.h"

#include <llvm/ADT/PostOrderIterator.h>
#include <llvm/Analysis/TargetTransformInfo.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Instructions.h>

namespace voxc {
namespace {

bool isMask(const llvm::Type *type) {
  const auto *vector = llvm::dyn_cast<llvm::FixedVectorType>(type);
  return vector != nullptr && vector->getElementType()->isIntegerTy(1);
}

bool usesMask(const llvm::Instruction &instruction) {
  return llvm::any_of(instruction.operands(), [](const llvm::Use &use) { return isMask(use->getType()); });
}

class MaskWidener {
public:
  MaskWidener(llvm::Function &function, const llvm::TargetTransformInfo &target);

  bool run();

private:
  llvm::Type *wideType(llvm::Type *mask) {
    return llvm::VectorType::get(builder_.getInt32Ty(), llvm::cast<llvm::FixedVectorType>(mask));
  }

  llvm::Value *wide(llvm::Value *mask);
  llvm::Value *widened(llvm::Instruction &mask);
  llvm::Value *chosen(llvm::SelectInst &choice);
  void endPhis();
  void use(llvm::Instruction &user);

  llvm::IRBuilder<> builder_;
  llvm::DenseMap<llvm::Value *, llvm::Value *> wide_;
  llvm::SmallVector<llvm::Instruction *, 32> masks_; ///< Each behind what it is made of, but for phis.
  llvm::SmallVector<llvm::Instruction *, 32> users_; ///< What is no mask itself.
};

/// What stands for a mask.
llvm::Value *MaskWidener::wide(llvm::Value *mask) {
  if (auto *constant = llvm::dyn_cast<llvm::Constant>(mask))
    return builder_.CreateSExt(constant, wideType(mask->getType()));
  return wide_.lookup(mask);
}

/// One of two masks, by a truth for all lanes or by a third mask. Lanes of what is not chosen may hold
/// poison.
llvm::Value *MaskWidener::chosen(llvm::SelectInst &choice) {
  llvm::Value *yes = wide(choice.getTrueValue()), *no = wide(choice.getFalseValue());
  if (!isMask(choice.getCondition()->getType()))
    return builder_.CreateSelect(choice.getCondition(), yes, no);
  llvm::Value *condition = wide(choice.getCondition());
  yes = builder_.CreateAnd(condition, builder_.CreateFreeze(yes));
  no = builder_.CreateAnd(builder_.CreateNot(condition), builder_.CreateFreeze(no));
  return builder_.CreateOr(yes, no);
}

llvm::Value *MaskWidener::widened(llvm::Instruction &mask) {
  llvm::Type *type = wideType(mask.getType());
  if (auto *phi = llvm::dyn_cast<llvm::PHINode>(&mask))
    return builder_.CreatePHI(type, phi->getNumIncomingValues());
  if (auto *operation = llvm::dyn_cast<llvm::BinaryOperator>(&mask))
    return builder_.CreateBinOp(operation->getOpcode(), wide(operation->getOperand(0)),
                                wide(operation->getOperand(1)));
  if (auto *choice = llvm::dyn_cast<llvm::SelectInst>(&mask))
    return chosen(*choice);
  if (llvm::isa<llvm::FreezeInst>(mask))
    return builder_.CreateFreeze(wide(mask.getOperand(0)));
  builder_.SetInsertPoint(mask.getNextNode());
  return builder_.CreateSExt(&mask, type);
}

/// Gives phis what comes to them, once all of it is there.
void MaskWidener::endPhis() {
  for (llvm::Instruction *mask : masks_) {
    auto *phi = llvm::dyn_cast<llvm::PHINode>(mask);
    if (phi == nullptr)
      continue;
    auto *other = llvm::cast<llvm::PHINode>(wide_.lookup(phi));
    for (unsigned i = 0; i < phi->getNumIncomingValues(); ++i)
      other->addIncoming(wide(phi->getIncomingValue(i)), phi->getIncomingBlock(i));
  }
}

/// Has an instruction that is no mask take wide ones in place of its masks. A comparison it takes as it is.
void MaskWidener::use(llvm::Instruction &user) {
  builder_.SetInsertPoint(&user);
  for (llvm::Use &operand : user.operands())
    if (wide_.contains(operand) && !llvm::isa<llvm::CmpInst>(operand)) {
      llvm::Value *mask = wide(operand);
      operand.set(builder_.CreateICmpSLT(mask, llvm::Constant::getNullValue(mask->getType())));
    }
}

MaskWidener::MaskWidener(llvm::Function &function, const llvm::TargetTransformInfo &target)
    : builder_(function.getContext()) {
  for (llvm::BasicBlock *block : llvm::ReversePostOrderTraversal<llvm::Function *>(&function))
    for (llvm::Instruction &instruction : *block)
      if (isMask(instruction.getType()) && !target.isTypeLegal(instruction.getType()))
        masks_.push_back(&instruction);
      else if (!isMask(instruction.getType()) && usesMask(instruction))
        users_.push_back(&instruction);
}

bool MaskWidener::run() {
  for (llvm::Instruction *mask : masks_) {
    builder_.SetInsertPoint(mask);
    wide_[mask] = widened(*mask);
  }
  endPhis();
  for (llvm::Instruction *user : users_)
    use(*user);
  return !masks_.empty();
}

} // namespace

llvm::PreservedAnalyses WideMasksPass::run(llvm::Function &function,
                                           llvm::FunctionAnalysisManager &analyses) {
  const auto &target = analyses.getResult<llvm::TargetIRAnalysis>(function);
  return MaskWidener(function, target).run() ? llvm::PreservedAnalyses::none()
                                             : llvm::PreservedAnalyses::all();
}

} // namespace voxc
