// From a format to a kernel for this processor.
#include "voxc/Kernel/CompileCpu.h"

#include "Jit/Jit.h"
#include "Jit/Variants.h"

#include "voxc/Emit/Emit.h"
#include "voxc/Support/EmbeddedFile.h"

#include <algorithm>
#include <array>

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

ClangOptions optionsFor(const std::string &processor, ObjectSystem system = ObjectSystem::Own) {
  return {.optimisation = 3,
          .isKernel = true,
          .processor = processor,
          .forWindows = system == ObjectSystem::Windows};
}

/// The parts of a kernel's text, as cpu-runtime/voxc_lanes.h numbers them.
enum Parts { kBatches = 1, kPackets = 2, kExactness = 4, kAll = kBatches + kPackets + kExactness };

int partsAtOnce(CpuStart start) {
  constexpr std::array kParts = {int{kBatches}, kBatches + kPackets, int{kAll}};
  return kParts[static_cast<std::size_t>(start)];
}

Expected<std::string> compileParts(const std::string &text, int parts, const CompileCache *cache) {
  ClangOptions options = optionsFor("native");
  options.macros = {"VOXC_PARTS=" + std::to_string(parts)};
  return compileToObject(kernelFiles(text), options, cache);
}

/// A part that waits until one of its functions is called, and keeps what it needs for that.
LaterPart laterPart(const std::shared_ptr<const std::string> &text, Parts part,
                    std::vector<std::string> functions, const CompileCache *cache) {
  const auto kept = cache ? std::make_shared<const CompileCache>(*cache) : nullptr;
  return {std::move(functions), [=] { return compileParts(*text, part, kept.get()); }};
}

/// The code of a kernel's text, with as much compiled as is asked for.
Expected<JitCode> codeOf(const Plan &plan, std::string text, const CpuKernelOptions &options) {
  const int parts = plan.isOfPoints() ? kAll : partsAtOnce(options.start);
  const auto object = VOXC_TRY(compileParts(text, parts, options.cache));
  const auto kept = std::make_shared<const std::string>(std::move(text));
  std::vector<LaterPart> later;
  if ((parts & kPackets) == 0)
    later.push_back(laterPart(kept, kPackets, {"trace_packet"}, options.cache));
  if ((parts & kExactness) == 0)
    later.push_back(laterPart(kept, kExactness, {"prepare", "go_on_exactly"}, options.cache));
  return JitCode::link(object, plan.layout.format, std::move(later));
}

} // namespace

Expected<CpuKernel> compileCpuKernel(const Format &format, const CpuKernelOptions &options) {
  PlanOptions planned = kCpuPlan;
  planned.addressing = options.addressing;
  const auto plan = makePlan(format, planned);
  return plan ? compileCpuKernel(*plan, options) : plan.error();
}

Expected<CpuKernel> compileCpuKernel(const Plan &plan, const CpuKernelOptions &options) {
  if (const std::string problem = problemOf(plan, EmitTarget::Processor); !problem.empty())
    return Error::input(problem);
  auto code = VOXC_TRY(codeOf(plan, emitIntersectCpp(plan, kSymbol, options.countWords), options));
  const auto function = VOXC_TRY(code.find(kSymbol));
  return CpuKernel{reinterpret_cast<CpuKernel::Function>(function),
                   plan.layout.storageDigest,
                   std::make_shared<const JitCode>(std::move(code)),
                   options.countWords,
                   plan.addressing == Addressing::Paged,
                   plan.bounded};
}

Expected<std::string> compileCpuObject(const Format &format, const CpuObjectOptions &options) {
  const auto plan = makePlan(format, kCpuPlan);
  return plan ? compileCpuObject(*plan, options) : plan.error();
}

Expected<std::string> compileCpuObject(const Plan &plan, const CpuObjectOptions &options) {
  if (!isFunctionName(options.symbol))
    return Error::usage("'" + options.symbol + "' is no name of a C function");
  if (!kHasVariants && options.system == ObjectSystem::Windows)
    return Error::usage("objects for Windows are made on x86-64 processors, which it runs on");
  if (const std::string problem = problemOf(plan, EmitTarget::Processor); !problem.empty())
    return Error::input(problem);
  const std::string text = emitIntersectCpp(plan, options.symbol);
  if (!kHasVariants || !options.processor.empty())
    return compileToObject(kernelFiles(text), optionsFor(options.processor, options.system));
  const std::string dispatch = emitDispatchCpp(options.symbol);
  return compileVariants(kernelFiles(text), optionsFor("", options.system), kVariants,
                         {"dispatch.cpp", dispatch});
}

} // namespace voxc
