// Masks of packets as integers as wide as most values, for processors without registers for masks.
#pragma once

#include <llvm/IR/PassManager.h>

namespace voxc {

/// Makes of each vector of single bits one of integers of 32 bits, 0 or -1, where the processor has no such
/// vectors: what comparisons give there, and what lanes are chosen by. Without this LLVM keeps them between
/// blocks in integers of another width, and converts them at each use. Runs behind all that looks at masks.
class WideMasksPass : public llvm::PassInfoMixin<WideMasksPass> {
public:
  llvm::PreservedAnalyses run(llvm::Function &function, llvm::FunctionAnalysisManager &analyses);
  static bool isRequired() { return true; }
};

} // namespace voxc
