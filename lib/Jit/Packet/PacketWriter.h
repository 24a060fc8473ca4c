// The body of a packet's function.
#pragma once

#include <llvm/Analysis/TargetTransformInfo.h>
#include <llvm/IR/Function.h>

namespace voxc {

/// Replaces the body of `function`, whose branches have two ways, which has one end, and whose loops are
/// simplified and in LCSSA form, by that of a packet of `lanes` for a processor. Gives an instruction that it
/// cannot write; the function is of no use then. Null if all is well.
const llvm::Instruction *writePacket(llvm::Function &function, unsigned lanes,
                                     const llvm::TargetTransformInfo &target);

} // namespace voxc
