#include "PacketPass.h"

#include "Lanes.h"
#include "PacketWriter.h"

#include <llvm/Analysis/TargetTransformInfo.h>
#include <llvm/IR/Constants.h>
#include <llvm/IR/DiagnosticInfo.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/Instructions.h>
#include <llvm/Transforms/Utils/LCSSA.h>
#include <llvm/Transforms/Utils/LoopSimplify.h>
#include <llvm/Transforms/Utils/LowerSwitch.h>
#include <llvm/Transforms/Utils/UnifyFunctionExitNodes.h>

namespace voxc {
namespace {

/// How many lanes a function asks for; 0 if it asks for none.
unsigned lanesOf(llvm::Function &function) {
  for (llvm::Instruction &instruction : llvm::instructions(function)) {
    const auto *call = llvm::dyn_cast<llvm::CallInst>(&instruction);
    const llvm::Function *callee = call == nullptr ? nullptr : call->getCalledFunction();
    if (callee != nullptr && callee->getName() == kLaneNumber)
      return static_cast<unsigned>(llvm::cast<llvm::ConstantInt>(call->getArgOperand(0))->getZExtValue());
  }
  return 0;
}

/// Outside of packets there is one lane. True if the function asked.
bool tellOneLane(llvm::Function &function) {
  bool asked = false;
  for (llvm::Instruction &instruction : llvm::make_early_inc_range(llvm::instructions(function))) {
    auto *call = llvm::dyn_cast<llvm::CallInst>(&instruction);
    const llvm::Function *callee = call == nullptr ? nullptr : call->getCalledFunction();
    if (callee == nullptr || callee->getName() != kLanesAtWork)
      continue;
    call->replaceAllUsesWith(llvm::ConstantInt::get(call->getType(), 1));
    call->eraseFromParent();
    asked = true;
  }
  return asked;
}

} // namespace

llvm::PreservedAnalyses PacketPass::run(llvm::Function &function, llvm::FunctionAnalysisManager &analyses) {
  const unsigned lanes = lanesOf(function);
  if (lanes == 0)
    return tellOneLane(function) ? llvm::PreservedAnalyses::none() : llvm::PreservedAnalyses::all();
  const auto prepare = [&](auto pass) { analyses.invalidate(function, pass.run(function, analyses)); };
  // Branches of two ways, one end, loops with one way in and one way back, whose values leave them by phis.
  prepare(llvm::LowerSwitchPass());
  prepare(llvm::UnifyFunctionExitNodesPass());
  prepare(llvm::LoopSimplifyPass());
  prepare(llvm::LCSSAPass());
  const llvm::TargetTransformInfo &target = analyses.getResult<llvm::TargetIRAnalysis>(function);
  if (const llvm::Instruction *unknown = writePacket(function, lanes, target)) {
    std::string text = "voxc cannot make a packet of: ";
    llvm::raw_string_ostream(text) << *unknown;
    function.getContext().diagnose(llvm::DiagnosticInfoUnsupported(function, text));
  }
  const unsigned bits = 32 * lanes;
  function.addFnAttr("min-legal-vector-width", std::to_string(bits));
  function.addFnAttr("prefer-vector-width", std::to_string(bits));
  // Registers that are kept on the stack would lie across two cache lines, as nothing else there asks for so
  // wide an alignment.
  function.addFnAttr("stackrealign");
  return llvm::PreservedAnalyses::none();
}

} // namespace voxc
