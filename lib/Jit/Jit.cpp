// LLVM's ORC: object code to callable code.
#include "Jit.h"

#include <llvm/ExecutionEngine/Orc/LLJIT.h>
#include <llvm/Support/MemoryBuffer.h>

namespace voxc {
namespace {

Error fromLlvm(llvm::Error error) {
  return Error::environment("the just-in-time compiler failed: " + llvm::toString(std::move(error)));
}

} // namespace

struct JitCode::State {
  std::unique_ptr<llvm::orc::LLJIT> jit;
};

JitCode::JitCode(std::unique_ptr<State> state) : state_(std::move(state)) {}
JitCode::~JitCode() = default;
JitCode::JitCode(JitCode &&) noexcept = default;

Expected<JitCode> JitCode::link(std::string_view object) {
  initializeTarget(); // The object may have been compiled by an earlier process.
  auto jit = llvm::orc::LLJITBuilder().create();
  if (!jit)
    return fromLlvm(jit.takeError());
  auto buffer = llvm::MemoryBuffer::getMemBufferCopy({object.data(), object.size()});
  if (auto error = (*jit)->addObjectFile(std::move(buffer)))
    return fromLlvm(std::move(error));
  return JitCode(std::make_unique<State>(State{std::move(*jit)}));
}

Expected<JitCode> JitCode::compile(const std::vector<MemoryFile> &files, const ClangOptions &options,
                                   const CompileCache *cache) {
  auto object = compileToObject(files, options, cache);
  if (!object)
    return object.error();
  return link(*object);
}

Expected<void *> JitCode::find(const std::string &name) const {
  auto address = state_->jit->lookup(name);
  if (!address)
    return fromLlvm(address.takeError());
  return address->toPtr<void *>();
}

} // namespace voxc
