#include "LazyLinker.h"

#include <llvm/ExecutionEngine/Orc/IndirectionUtils.h>
#include <llvm/Support/ErrorHandling.h>
#include <llvm/Support/MemoryBuffer.h>

#include <future>
#include <system_error>

namespace voxc {
namespace {

namespace orc = llvm::orc;

/// There is no way back from the middle of a kernel.
[[noreturn]] void endProcess() { llvm::report_fatal_error("voxc cannot compile a part of a kernel"); }

/// On a thread of its own where there may be one: that of whoever traces may have a stack too small for a
/// compiler.
Expected<std::string> compiled(const LaterPart &part) {
  try {
    return std::async(std::launch::async, part.compile).get();
  } catch (const std::system_error &) {
    return part.compile();
  }
}

/// What ORC knows of a part before it is compiled.
class PartUnit final : public orc::MaterializationUnit {
public:
  PartUnit(orc::LLJIT &jit, orc::SymbolFlagsMap functions, LaterPart part)
      : MaterializationUnit(Interface(std::move(functions), nullptr)), jit_(jit), part_(std::move(part)) {}

  llvm::StringRef getName() const override { return "a part that is compiled later"; }

  void materialize(std::unique_ptr<orc::MaterializationResponsibility> responsibility) override {
    const Expected<std::string> object = compiled(part_);
    if (object)
      return jit_.getObjLinkingLayer().emit(std::move(responsibility),
                                            llvm::MemoryBuffer::getMemBufferCopy(*object));
    jit_.getExecutionSession().reportError(
        llvm::createStringError(llvm::inconvertibleErrorCode(), object.error().message));
    responsibility->failMaterialization();
  }

private:
  void discard(const orc::JITDylib &, const orc::SymbolStringPtr &) override {}

  orc::LLJIT &jit_;
  LaterPart part_;
};

} // namespace

llvm::Expected<std::unique_ptr<LazyLinker>> LazyLinker::define(orc::LLJIT &jit,
                                                               std::vector<LaterPart> parts) {
  auto linker = std::make_unique<LazyLinker>();
  const llvm::Triple &triple = jit.getTargetTriple();
  auto calls = orc::createLocalLazyCallThroughManager(triple, jit.getExecutionSession(),
                                                      orc::ExecutorAddr::fromPtr(&endProcess));
  if (!calls)
    return calls.takeError();
  linker->calls_ = std::move(*calls);
  linker->stubs_ = orc::createLocalIndirectStubsManagerBuilder(triple)();
  auto behind = jit.createJITDylib("later");
  if (!behind)
    return behind.takeError();
  orc::SymbolAliasMap stubs;
  constexpr auto kFlags = llvm::JITSymbolFlags::Exported | llvm::JITSymbolFlags::Callable;
  for (LaterPart &part : parts) {
    orc::SymbolFlagsMap functions;
    for (const std::string &name : part.functions) {
      const orc::SymbolStringPtr symbol = jit.mangleAndIntern(name);
      functions[symbol] = kFlags;
      stubs[symbol] = orc::SymbolAliasMapEntry(symbol, kFlags);
    }
    if (auto error = behind->define(std::make_unique<PartUnit>(jit, std::move(functions), std::move(part))))
      return error;
  }
  if (auto error = jit.getMainJITDylib().define(
          orc::lazyReexports(*linker->calls_, *linker->stubs_, *behind, std::move(stubs))))
    return error;
  return linker;
}

} // namespace voxc
