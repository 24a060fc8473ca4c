// From a format to a kernel for this processor.
#include "voxc/Kernel/CompileCpu.h"

#include "Jit/Jit.h"
#include "Jit/Variants.h"

#include "voxc/Emit/Emit.h"
#include "voxc/Support/EmbeddedFile.h"

#include <algorithm>
#include <cctype>

namespace voxc {
namespace {

constexpr const char *kSymbol = "voxc_intersect";

/// The processors between which an object picks when it runs; cpu-runtime/dispatch.cpp calls them by name.
constexpr const char *kVariants[] = {"x86-64-v4", "x86-64-v3", "x86-64"};

/// Other architectures have their baseline alone.
#ifdef __x86_64__
constexpr bool kHasVariants = true;
#else
constexpr bool kHasVariants = false;
#endif

std::vector<MemoryFile> kernelFiles(const std::string &text) {
  std::vector<MemoryFile> files = {{"intersect.cpp", text}};
  for (const EmbeddedFile &header : intersectHeaders())
    files.push_back({std::string(header.path), header.text});
  return files;
}

ClangOptions optionsFor(const std::string &processor) {
  return {.optimisation = 3, .isKernel = true, .processor = processor};
}

Expected<std::string> compile(const std::string &text, const std::string &processor,
                              const CompileCache *cache = nullptr) {
  return compileToObject(kernelFiles(text), optionsFor(processor), cache);
}

bool isIdentifier(const std::string &name) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  return !name.empty() && !std::isdigit(static_cast<unsigned char>(name[0])) &&
         std::ranges::all_of(name, fits);
}

} // namespace

Expected<CpuKernel> compileCpuKernel(const Format &format, bool countWords, const CompileCache *cache,
                                     Addressing addressing) {
  PlanOptions options = kCpuPlan;
  options.addressing = addressing;
  const auto plan = makePlan(format, options);
  return plan ? compileCpuKernel(*plan, countWords, cache) : plan.error();
}

Expected<CpuKernel> compileCpuKernel(const Plan &plan, bool countWords, const CompileCache *cache) {
  if (const std::string problem = problemOf(plan, EmitTarget::Processor); !problem.empty())
    return Error::input(problem);
  const auto object = compile(emitIntersectCpp(plan, kSymbol, countWords), "native", cache);
  if (!object)
    return object.error();
  auto code = JitCode::link(*object, plan.layout.format);
  if (!code)
    return code.error();
  const auto function = code->find(kSymbol);
  if (!function)
    return function.error();
  return CpuKernel{reinterpret_cast<CpuKernel::Function>(*function),
                   plan.layout.storageDigest,
                   std::make_shared<const JitCode>(std::move(*code)),
                   countWords,
                   plan.addressing == Addressing::Paged,
                   plan.bounded};
}

Expected<std::string> compileCpuObject(const Format &format, const CpuObjectOptions &options) {
  const auto plan = makePlan(format, kCpuPlan);
  return plan ? compileCpuObject(*plan, options) : plan.error();
}

Expected<std::string> compileCpuObject(const Plan &plan, const CpuObjectOptions &options) {
  if (!isIdentifier(options.symbol))
    return Error::usage("'" + options.symbol + "' is no name of a C function");
  if (const std::string problem = problemOf(plan, EmitTarget::Processor); !problem.empty())
    return Error::input(problem);
  const std::string text = emitIntersectCpp(plan, options.symbol);
  if (!kHasVariants || !options.processor.empty())
    return compile(text, options.processor);
  const std::string dispatch = emitDispatchCpp(options.symbol);
  return compileVariants(kernelFiles(text), optionsFor(""), kVariants, {"dispatch.cpp", dispatch});
}

} // namespace voxc
