// Packets: of a function for one lane, the function for all.
//
// Every way through the function is gone by every packet that has a lane on it, and each value that matters
// is chosen by masks: whole-function vectorization, after Karrenberg and Hack (CGO 2011).
#pragma once

#include <llvm/IR/PassManager.h>

namespace voxc {

/// Widens each function that calls `voxc_lane_number(lanes)` to as many lanes as it says, where the number of
/// the lane is 0, 1, 2... An instruction that cannot be widened is an error of the compiler's context.
class PacketPass : public llvm::PassInfoMixin<PacketPass> {
public:
  llvm::PreservedAnalyses run(llvm::Function &function, llvm::FunctionAnalysisManager &analyses);
  static bool isRequired() { return true; }
};

} // namespace voxc
