// LLVM's ORC: modules to code.
#include "Jit.h"

#include "ClangFrontend.h"

#include <llvm/ExecutionEngine/Orc/LLJIT.h>
#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>
#include <llvm/Support/TargetSelect.h>

#include <mutex>

namespace voxc {
namespace {

Error fromLlvm(llvm::Error error) {
  return Error::environment("the just-in-time compiler failed: " + llvm::toString(std::move(error)));
}

void initializeTarget() {
  static std::once_flag once;
  std::call_once(once, [] {
    llvm::InitializeNativeTarget();
    llvm::InitializeNativeTargetAsmPrinter();
  });
}

} // namespace

struct JitCode::State {
  std::unique_ptr<llvm::orc::LLJIT> jit;
};

JitCode::JitCode(std::unique_ptr<State> state) : state_(std::move(state)) {}
JitCode::~JitCode() = default;
JitCode::JitCode(JitCode &&) noexcept = default;

Expected<JitCode> JitCode::compile(const std::vector<MemoryFile> &files) {
  initializeTarget();
  auto context = std::make_unique<llvm::LLVMContext>();
  auto module = compileToModule(files, *context);
  if (!module)
    return module.error();
  auto jit = llvm::orc::LLJITBuilder().create();
  if (!jit)
    return fromLlvm(jit.takeError());
  (*module)->setDataLayout((*jit)->getDataLayout());
  if (auto error = (*jit)->addIRModule(llvm::orc::ThreadSafeModule(std::move(*module), std::move(context))))
    return fromLlvm(std::move(error));
  return JitCode(std::make_unique<State>(State{std::move(*jit)}));
}

Expected<void *> JitCode::find(const std::string &name) const {
  auto address = state_->jit->lookup(name);
  if (!address)
    return fromLlvm(address.takeError());
  return address->toPtr<void *>();
}

} // namespace voxc
