#include "ObjectCode.h"

#include <llvm/ADT/SmallString.h>
#include <llvm/IR/LegacyPassManager.h>
#include <llvm/MC/TargetRegistry.h>
#include <llvm/Support/raw_ostream.h>

namespace voxc {

Expected<std::unique_ptr<llvm::TargetMachine>> machineOf(const llvm::Module &module) {
  std::string error;
  const llvm::Target *target = llvm::TargetRegistry::lookupTarget(module.getTargetTriple(), error);
  if (target == nullptr)
    return Error::environment(error);
  return std::unique_ptr<llvm::TargetMachine>(target->createTargetMachine(module.getTargetTriple(), "", "",
                                                                          {}, llvm::Reloc::PIC_, std::nullopt,
                                                                          llvm::CodeGenOptLevel::Aggressive));
}

Expected<std::string> objectOf(llvm::Module &module, llvm::TargetMachine &machine) {
  llvm::SmallString<0> object;
  llvm::raw_svector_ostream stream(object);
  llvm::legacy::PassManager passes;
  if (machine.addPassesToEmitFile(passes, stream, nullptr, llvm::CodeGenFileType::ObjectFile,
                                  /*DisableVerify=*/true))
    return Error::environment("LLVM writes no object files for " + module.getTargetTriple());
  passes.run(module);
  return std::string(object);
}

} // namespace voxc
