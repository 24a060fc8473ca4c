// Clang's archives ask for Polly, an optimiser of loops, which is in none of them. Programs that have Clang
// within have this in its place: nothing is registered. Compiled for them alone.
#include <llvm/Passes/PassPlugin.h>

llvm::PassPluginLibraryInfo getPollyPluginInfo() {
  return {LLVM_PLUGIN_API_VERSION, "no Polly", "", [](llvm::PassBuilder &) {}};
}
