// LLVM's ORC: object code to callable code, which debuggers and profilers know by its names.
#include "Jit.h"

#include "DebuggerEntries.h"
#include "LazyLinker.h"
#include "PerfMap.h"

#include <llvm/Demangle/Demangle.h>
#include <llvm/ExecutionEngine/Orc/DebugObjectManagerPlugin.h>
#include <llvm/ExecutionEngine/Orc/EPCDebugObjectRegistrar.h>
#include <llvm/ExecutionEngine/Orc/LLJIT.h>
#include <llvm/ExecutionEngine/Orc/ObjectLinkingLayer.h>
#include <llvm/Support/MemoryBuffer.h>

namespace voxc {
namespace {

namespace orc = llvm::orc;
namespace jitlink = llvm::jitlink;

Error fromLlvm(llvm::Error error) {
  return Error::environment("the just-in-time compiler failed: " + llvm::toString(std::move(error)));
}

/// Tells perf's map of all functions that are linked.
class PerfPlugin final : public orc::ObjectLinkingLayer::Plugin {
public:
  PerfPlugin(PerfMap &map, std::string_view label)
      : map_(map), suffix_(label.empty() ? "" : " [" + std::string(label) + "]") {}

  void modifyPassConfig(orc::MaterializationResponsibility &, jitlink::LinkGraph &,
                        jitlink::PassConfiguration &passes) override {
    // Calls within a section have no relocation, and what nothing refers to would have lost its name by then.
    passes.PrePrunePasses.emplace_back([](jitlink::LinkGraph &graph) {
      for (jitlink::Symbol *symbol : graph.defined_symbols())
        symbol->setLive(symbol->isLive() || symbol->isCallable());
      return llvm::Error::success();
    });
    passes.PostFixupPasses.emplace_back([this](jitlink::LinkGraph &graph) {
      for (const jitlink::Symbol *symbol : graph.defined_symbols())
        if (symbol->hasName() && symbol->isCallable())
          map_.add(symbol->getAddress().getValue(), symbol->getSize(),
                   llvm::demangle(symbol->getName()) + suffix_);
      return llvm::Error::success();
    });
  }
  llvm::Error notifyFailed(orc::MaterializationResponsibility &) override { return llvm::Error::success(); }
  llvm::Error notifyRemovingResources(orc::JITDylib &, orc::ResourceKey) override {
    return llvm::Error::success();
  }
  void notifyTransferringResources(orc::JITDylib &, orc::ResourceKey, orc::ResourceKey) override {}

private:
  PerfMap &map_;
  std::string suffix_;
};

/// Tells debuggers of object files. LLVM's own registrar never withdraws one, which then points to memory
/// that is gone.
class Registrar final : public orc::DebugObjectRegistrar {
public:
  explicit Registrar(std::shared_ptr<DebuggerEntries> entries) : entries_(std::move(entries)) {}

  llvm::Error registerDebugObject(orc::ExecutorAddrRange object, bool) override {
    entries_->add(object.Start.toPtr<const char *>(), object.size());
    return llvm::Error::success();
  }

private:
  std::shared_ptr<DebuggerEntries> entries_;
};

/// Other linkers than JITLink, which LLVM has for this processor where it can, know no plugins.
void addPlugins(orc::LLJIT &jit, const std::shared_ptr<DebuggerEntries> &entries, std::string_view label) {
  auto *const layer = llvm::dyn_cast<orc::ObjectLinkingLayer>(&jit.getObjLinkingLayer());
  if (!layer)
    return;
  layer->addPlugin(std::make_unique<orc::DebugObjectManagerPlugin>(
      jit.getExecutionSession(), std::make_unique<Registrar>(entries), /*RequireDebugSections=*/false,
      /*AutoRegisterCode=*/true));
  if (PerfMap *const map = PerfMap::asked())
    layer->addPlugin(std::make_unique<PerfPlugin>(*map, label));
}

} // namespace

struct JitCode::State {
  ~State() { entries->withdraw(); } // Before the code and what is told of it goes.

  std::unique_ptr<orc::LLJIT> jit;
  std::unique_ptr<LazyLinker> lazy;
  std::shared_ptr<DebuggerEntries> entries = std::make_shared<DebuggerEntries>();
};

JitCode::JitCode(std::unique_ptr<State> state) : state_(std::move(state)) {}
JitCode::~JitCode() = default;
JitCode::JitCode(JitCode &&) noexcept = default;

Expected<JitCode> JitCode::link(std::string_view object, std::string_view label,
                                std::vector<LaterPart> later) {
  initializeTarget(); // The object may have been compiled by an earlier process.
  auto jit = orc::LLJITBuilder().create();
  if (!jit)
    return fromLlvm(jit.takeError());
  auto state = std::make_unique<State>();
  state->jit = std::move(*jit);
  addPlugins(*state->jit, state->entries, label);
  if (!later.empty()) {
    auto lazy = LazyLinker::define(*state->jit, std::move(later));
    if (!lazy)
      return fromLlvm(lazy.takeError());
    state->lazy = std::move(*lazy);
  }
  auto buffer = llvm::MemoryBuffer::getMemBufferCopy({object.data(), object.size()});
  if (auto error = state->jit->addObjectFile(std::move(buffer)))
    return fromLlvm(std::move(error));
  return JitCode(std::move(state));
}

Expected<JitCode> JitCode::compile(const std::vector<MemoryFile> &files, const ClangOptions &options,
                                   const CompileCache *cache, std::string_view label) {
  auto object = compileToObject(files, options, cache);
  if (!object)
    return object.error();
  return link(*object, label);
}

Expected<void *> JitCode::find(const std::string &name) const {
  auto address = state_->jit->lookup(name); // What it links now is named.
  if (!address)
    return fromLlvm(address.takeError());
  if (const PerfMap *const map = PerfMap::asked())
    if (auto problem = map->problem())
      return *problem;
  return address->toPtr<void *>();
}

} // namespace voxc
