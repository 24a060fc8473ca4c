// Variants are modules of LLVM, compiled each by itself, and joined when nothing is inlined any more: an
// instruction that a processor lacks never comes into what another runs.
#include "Variants.h"

#include "ObjectCode.h"

#include <llvm/ADT/StringSet.h>
#include <llvm/Bitcode/BitcodeReader.h>
#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>
#include <llvm/Linker/Linker.h>
#include <llvm/Transforms/IPO/Internalize.h>

#include <algorithm>
#include <future>

namespace voxc {
namespace {

/// Behind the names of a processor's functions: letters that demanglers know.
std::string suffixOf(std::string processor) {
  std::ranges::replace(processor, '-', '_');
  return "." + processor;
}

/// Gives what a module defines names of its own. Without groups of equal functions, of which a linker would
/// keep one for all.
void rename(llvm::Module &module, const std::string &suffix) {
  for (llvm::GlobalValue &value : module.global_values())
    if (!value.isDeclaration() && !value.hasAppendingLinkage())
      value.setName(value.getName() + suffix);
  for (llvm::GlobalObject &object : module.global_objects())
    object.setComdat(nullptr);
}

/// What a module defines and shows.
llvm::StringSet<> exports(const llvm::Module &module) {
  llvm::StringSet<> names;
  for (const llvm::GlobalValue &value : module.global_values())
    if (!value.isDeclaration() && !value.hasLocalLinkage())
      names.insert(value.getName());
  return names;
}

std::unique_ptr<llvm::Module> readModule(const std::string &bitcode, llvm::LLVMContext &context) {
  // It was written a moment ago, by the same library.
  return llvm::cantFail(llvm::parseBitcodeFile({bitcode, "variant"}, context));
}

} // namespace

Expected<std::string> compileVariants(const std::vector<MemoryFile> &files, const ClangOptions &options,
                                      std::span<const char *const> processors, const MemoryFile &dispatcher) {
  std::vector<std::future<Expected<std::string>>> variants;
  for (const char *processor : processors) {
    ClangOptions own = options;
    own.processor = processor;
    variants.push_back(
        std::async(std::launch::async, [&files, own] { return compileToBitcode(files, own); }));
  }
  const auto choice = compileToBitcode(
      {dispatcher},
      {.optimisation = options.optimisation, .processor = "", .forWindows = options.forWindows});
  if (!choice)
    return choice.error();

  llvm::LLVMContext context;
  const std::unique_ptr<llvm::Module> joined = readModule(*choice, context);
  const llvm::StringSet<> exported = exports(*joined);
  llvm::Linker linker(*joined);
  for (std::size_t i = 0; i < processors.size(); ++i) {
    const auto bitcode = variants[i].get();
    if (!bitcode)
      return bitcode.error();
    std::unique_ptr<llvm::Module> variant = readModule(*bitcode, context);
    rename(*variant, suffixOf(processors[i]));
    if (linker.linkInModule(std::move(variant)))
      return Error::input("the variants of " + files.front().name + " cannot be joined");
  }
  llvm::internalizeModule(*joined,
                          [&](const llvm::GlobalValue &value) { return exported.contains(value.getName()); });
  const auto machine = machineOf(*joined);
  return machine ? objectOf(*joined, **machine) : machine.error();
}

} // namespace voxc
