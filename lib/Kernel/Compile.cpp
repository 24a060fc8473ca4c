// From a format to a kernel: the stages in their order.
#include "voxc/Kernel/Compile.h"

#include "Stages.h"

#include "voxc/Emit/Emit.h"

#include <cstring>

namespace voxc {

namespace {

constexpr std::string_view kCacheKind = "spirv";

std::string_view bytesOf(const SpirvWords &words) {
  return {reinterpret_cast<const char *>(words.data()), words.size() * sizeof words[0]};
}

SpirvWords wordsOf(std::string_view bytes) {
  SpirvWords words(bytes.size() / sizeof(std::uint32_t));
  std::memcpy(words.data(), bytes.data(), words.size() * sizeof words[0]);
  return words;
}

/// What is known of a plan's kernel before it is compiled.
Kernel kernelOf(const Plan &plan) {
  return {{}, plan.layout.storageDigest, plan.addressing, plan.loops, plan.arithmetic, plan.bounded};
}

} // namespace

Expected<Kernel> compileGlsl(std::string_view glsl, const Plan &plan, bool optimise) {
  auto module = glslToSpirv({.glsl = glsl});
  if (module && optimise)
    module = optimiseSpirv(*module);
  if (!module)
    return module.error();
  Kernel kernel = kernelOf(plan);
  kernel.spirv = addModuleProcessed(*module, kernelFacts(kernel));
  VOXC_TRY(validateSpirv(kernel.spirv));
  return kernel;
}

Expected<Kernel> compileKernel(const Format &format, const KernelOptions &options) {
  const auto plan = makePlan(format, {options.addressing, options.loops, options.arithmetic});
  return plan ? compileKernel(*plan, options.optimise, options.cache) : plan.error();
}

Expected<Kernel> compileKernel(const Plan &plan, bool optimise, const CompileCache *cache) {
  if (const std::string problem = problemOf(plan, EmitTarget::Device); !problem.empty())
    return Error::input(problem);
  const std::string glsl = emitIntersect(plan);
  if (!cache)
    return compileGlsl(glsl, plan, optimise);
  // glslang and SPIRV-Tools are part of this very program or library, which the cache tells by itself.
  // The module says what it was made for, which its text need not.
  const std::string facts = kernelFacts(kernelOf(plan));
  const std::string_view parts[] = {glsl, facts, optimise ? "optimised" : ""};
  if (const std::optional<std::string> found = cache->find(kCacheKind, parts))
    if (auto kernel = Kernel::fromSpirv(wordsOf(*found)))
      return kernel;
  auto kernel = compileGlsl(glsl, plan, optimise);
  if (kernel)
    cache->store(kCacheKind, parts, bytesOf(kernel->spirv));
  return kernel;
}

Expected<std::vector<std::uint32_t>> compileRayShader(const Plan &plan, std::string_view name,
                                                      RayStage stage) {
  constexpr EShLanguage kStages[] = {EShLangIntersect, EShLangClosestHit};
  const std::string glsl = emitRayShader(plan, name, stage);
  const std::string header = emitHeader(plan, name);
  const std::string headerName = headerFile(name);
  auto module = VOXC_TRY(glslToSpirv({kStages[static_cast<std::size_t>(stage)], glsl, headerName, header}));
  VOXC_TRY(validateSpirv(module));
  return module;
}

Expected<std::string> disassemble(const Kernel &kernel) { return disassembleSpirv(kernel.spirv); }

} // namespace voxc
