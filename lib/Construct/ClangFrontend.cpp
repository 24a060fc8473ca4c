// Clang as a library: cc1 arguments, an in-memory file system, IR out.
#include "ClangFrontend.h"

#include <clang/Basic/Diagnostic.h>
#include <clang/Basic/DiagnosticOptions.h>
#include <clang/CodeGen/CodeGenAction.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/CompilerInvocation.h>
#include <clang/Frontend/TextDiagnosticPrinter.h>
#include <llvm/IR/Module.h>
#include <llvm/IR/Verifier.h>
#include <llvm/Support/VirtualFileSystem.h>
#include <llvm/Support/raw_ostream.h>
#include <llvm/TargetParser/Host.h>

namespace voxc {
namespace {

/// cc1's arguments for freestanding C++20 on this very processor.
std::vector<std::string> arguments(const std::string &mainFile) {
  // -O1: a third less compile time than -O2, and builds that are as fast; they wait for the source, not for
  // this code.
  std::vector<std::string> list = {"-triple",
                                   llvm::sys::getDefaultTargetTriple(),
                                   "-emit-obj",
                                   "-x",
                                   "c++",
                                   "-std=c++20",
                                   "-O1",
                                   "-ffreestanding",
                                   "-nostdsysteminc",
                                   "-ffp-contract=off",
                                   "-fgnuc-version=4.2.1",
                                   "-mrelocation-model",
                                   "pic",
                                   "-pic-level",
                                   "2",
                                   "-target-cpu",
                                   llvm::sys::getHostCPUName().str()};
  for (const auto &feature : llvm::sys::getHostCPUFeatures()) {
    list.emplace_back("-target-feature");
    list.push_back((feature.getValue() ? "+" : "-") + feature.getKey().str());
  }
  list.push_back(mainFile);
  return list;
}

llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem> fileSystem(const std::vector<MemoryFile> &files) {
  auto memory = llvm::makeIntrusiveRefCnt<llvm::vfs::InMemoryFileSystem>();
  for (const MemoryFile &file : files)
    memory->addFile(file.name, 0, llvm::MemoryBuffer::getMemBufferCopy({file.text.data(), file.text.size()}));
  return memory;
}

} // namespace

Expected<std::unique_ptr<llvm::Module>> compileToModule(const std::vector<MemoryFile> &files,
                                                        llvm::LLVMContext &context) {
  std::string log;
  llvm::raw_string_ostream logStream(log);
  auto options = llvm::makeIntrusiveRefCnt<clang::DiagnosticOptions>();
  auto *printer = new clang::TextDiagnosticPrinter(logStream, options.get()); // Owned by the engine.
  auto diagnostics = llvm::makeIntrusiveRefCnt<clang::DiagnosticsEngine>(
      llvm::makeIntrusiveRefCnt<clang::DiagnosticIDs>(), options, printer);

  const std::vector<std::string> owned = arguments(files.front().name);
  const std::vector<const char *> list = [&] {
    std::vector<const char *> pointers;
    pointers.reserve(owned.size());
    for (const std::string &argument : owned)
      pointers.push_back(argument.c_str());
    return pointers;
  }();
  auto invocation = std::make_shared<clang::CompilerInvocation>();
  const bool valid = clang::CompilerInvocation::CreateFromArgs(*invocation, list, *diagnostics);

  clang::CompilerInstance compiler;
  compiler.setInvocation(invocation);
  compiler.setDiagnostics(diagnostics.get());
  clang::ProcessWarningOptions(*diagnostics, invocation->getDiagnosticOpts());
  compiler.createFileManager(fileSystem(files));
  compiler.createSourceManager(compiler.getFileManager());
  clang::EmitLLVMOnlyAction action(&context);
  if (!valid || !compiler.ExecuteAction(action))
    return Error::input("clang rejects the construction code: " + logStream.str());

  std::unique_ptr<llvm::Module> module = action.takeModule();
  // Debian's LLVM has no assertions: a broken module would crash the code generator instead of being
  // reported.
  if (!module || llvm::verifyModule(*module, &logStream))
    return Error::input("clang made a broken module of the construction code: " + logStream.str());
  return module;
}

} // namespace voxc
