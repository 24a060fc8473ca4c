// Clang as a library: cc1 arguments, an in-memory file system, object code or bitcode out.
#include "ClangFrontend.h"

#include "KernelPasses.h"
#include "ObjectCode.h"

#include <clang/Basic/Diagnostic.h>
#include <clang/Basic/DiagnosticOptions.h>
#include <clang/Basic/Version.h>
#include <clang/CodeGen/CodeGenAction.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/CompilerInvocation.h>
#include <clang/Frontend/TextDiagnosticPrinter.h>
#include <llvm/ADT/SmallString.h>
#include <llvm/Bitcode/BitcodeWriter.h>
#include <llvm/Support/TargetSelect.h>
#include <llvm/Support/VirtualFileSystem.h>
#include <llvm/Support/raw_ostream.h>
#include <llvm/TargetParser/Host.h>

#include <mutex>

namespace voxc {

void initializeTarget() {
  static std::once_flag once;
  std::call_once(once, [] {
    llvm::InitializeNativeTarget();
    llvm::InitializeNativeTargetAsmPrinter();
    llvm::InitializeNativeTargetAsmParser();
  });
}

namespace {

/// cc1's arguments for a processor.
std::vector<std::string> processorArguments(const std::string &processor) {
  if (processor.empty())
    return {};
  if (processor != "native")
    return {"-target-cpu", processor};
  std::vector<std::string> list = {"-target-cpu", llvm::sys::getHostCPUName().str()};
  for (const auto &feature : llvm::sys::getHostCPUFeatures()) {
    list.emplace_back("-target-feature");
    list.push_back((feature.getValue() ? "+" : "-") + feature.getKey().str());
  }
  return list;
}

/// Windows as MinGW-w64 has it. Other linkers of Windows take such objects too.
constexpr const char *kWindows = "x86_64-w64-windows-gnu";

/// cc1's arguments for freestanding C++20. Integers wrap, nothing is contracted and floats may be read as
/// their bits, as in the GLSL that kernels share with other devices.
std::vector<std::string> arguments(const std::string &mainFile, const ClangOptions &options) {
  std::vector<std::string> list = {"-triple",
                                   options.forWindows ? kWindows : llvm::sys::getDefaultTargetTriple(),
                                   "-emit-obj",
                                   "-x",
                                   "c++",
                                   "-std=c++20",
                                   "-O" + std::to_string(options.optimisation),
                                   "-ffreestanding",
                                   "-nostdsysteminc",
                                   "-fwrapv",
                                   "-relaxed-aliasing",
                                   "-ffp-contract=off",
                                   "-fgnuc-version=4.2.1",
                                   "-DVOXC_PACKETS",
                                   "-mrelocation-model",
                                   "pic",
                                   "-pic-level",
                                   "2"};
  for (std::string &argument : processorArguments(options.processor))
    list.push_back(std::move(argument));
  if (options.vectorLoops)
    list.emplace_back("-vectorize-loops");
  if (options.isKernel)
    list.insert(list.end(), {"-disable-llvm-passes", "-disable-llvm-verifier", "-discard-value-names"});
  for (const std::string &macro : options.macros)
    list.push_back("-D" + macro);
  list.push_back(mainFile);
  return list;
}

llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem> fileSystem(const std::vector<MemoryFile> &files) {
  auto memory = llvm::makeIntrusiveRefCnt<llvm::vfs::InMemoryFileSystem>();
  for (const MemoryFile &file : files)
    memory->addFile(file.name, 0, llvm::MemoryBuffer::getMemBufferCopy({file.text.data(), file.text.size()}));
  return memory;
}

/// What Clang writes when it takes `action` on the first of the files.
Expected<std::string> compile(clang::FrontendAction &action, const std::vector<MemoryFile> &files,
                              const ClangOptions &options) {
  initializeTarget();
  std::string log;
  llvm::raw_string_ostream logStream(log);
  auto diagnosticOptions = llvm::makeIntrusiveRefCnt<clang::DiagnosticOptions>();
  // Owned by the engine.
  auto *printer = new clang::TextDiagnosticPrinter(logStream, diagnosticOptions.get());
  auto diagnostics = llvm::makeIntrusiveRefCnt<clang::DiagnosticsEngine>(
      llvm::makeIntrusiveRefCnt<clang::DiagnosticIDs>(), diagnosticOptions, printer);

  const std::vector<std::string> owned = arguments(files.front().name, options);
  std::vector<const char *> list;
  list.reserve(owned.size());
  for (const std::string &argument : owned)
    list.push_back(argument.c_str());
  auto invocation = std::make_shared<clang::CompilerInvocation>();
  const bool valid = clang::CompilerInvocation::CreateFromArgs(*invocation, list, *diagnostics);

  clang::CompilerInstance compiler;
  compiler.setVerboseOutputStream(llvm::nulls()); // Where it would say how many warnings there were.
  compiler.setInvocation(invocation);
  compiler.setDiagnostics(diagnostics.get());
  clang::ProcessWarningOptions(*diagnostics, invocation->getDiagnosticOpts());
  compiler.createFileManager(fileSystem(files));
  compiler.createSourceManager(compiler.getFileManager());
  llvm::SmallString<0> output;
  compiler.setOutputStream(std::make_unique<llvm::raw_svector_ostream>(output));
  if (!valid || !compiler.ExecuteAction(action))
    return Error::input("clang rejects " + files.front().name + ": " + logStream.str());
  return std::string(output);
}

/// All that an object depends on: Clang, which is a library of its own, its arguments, and the files.
std::vector<std::string> keyOf(const std::vector<MemoryFile> &files, const ClangOptions &options) {
  std::vector<std::string> key = {clang::getClangFullVersion()};
  for (std::string &argument : arguments(files[0].name, options))
    key.push_back(std::move(argument));
  for (const MemoryFile &file : files) {
    key.push_back(file.name);
    key.emplace_back(file.text);
  }
  return key;
}

/// A kernel as a module, optimised, with what makes code of it.
struct KernelModule {
  llvm::LLVMContext context; // Outlives the module.
  std::unique_ptr<llvm::Module> module;
  std::unique_ptr<llvm::TargetMachine> machine;
};

Expected<std::unique_ptr<KernelModule>> compileKernel(const std::vector<MemoryFile> &files,
                                                      const ClangOptions &options) {
  auto kernel = std::make_unique<KernelModule>();
  clang::EmitLLVMOnlyAction action(&kernel->context);
  if (const Expected<std::string> written = compile(action, files, options); !written)
    return written.error();
  kernel->module = action.takeModule();
  auto machine = machineOf(*kernel->module);
  if (!machine)
    return machine.error();
  kernel->machine = std::move(*machine);
  if (const Expected<void> optimised = runKernelPasses(*kernel->module, *kernel->machine); !optimised)
    return optimised.error();
  return kernel;
}

Expected<std::string> kernelObject(const std::vector<MemoryFile> &files, const ClangOptions &options) {
  const auto kernel = compileKernel(files, options);
  return kernel ? objectOf(*(*kernel)->module, *(*kernel)->machine) : kernel.error();
}

Expected<std::string> kernelBitcode(const std::vector<MemoryFile> &files, const ClangOptions &options) {
  const auto kernel = compileKernel(files, options);
  if (!kernel)
    return kernel.error();
  llvm::SmallString<0> bitcode;
  llvm::raw_svector_ostream stream(bitcode);
  llvm::WriteBitcodeToFile(*(*kernel)->module, stream);
  return std::string(bitcode);
}

} // namespace

Expected<std::string> compileToObject(const std::vector<MemoryFile> &files, const ClangOptions &options,
                                      const CompileCache *cache) {
  constexpr std::string_view kCacheKind = "object";
  const std::vector<std::string> key = cache ? keyOf(files, options) : std::vector<std::string>();
  const std::vector<std::string_view> parts(key.begin(), key.end());
  if (cache)
    if (std::optional<std::string> found = cache->find(kCacheKind, parts))
      return std::move(*found);
  clang::EmitObjAction action;
  Expected<std::string> object =
      options.isKernel ? kernelObject(files, options) : compile(action, files, options);
  if (cache && object)
    cache->store(kCacheKind, parts, *object);
  return object;
}

Expected<std::string> compileToBitcode(const std::vector<MemoryFile> &files, const ClangOptions &options) {
  clang::EmitBCAction action;
  return options.isKernel ? kernelBitcode(files, options) : compile(action, files, options);
}

} // namespace voxc
