// From a format to a kernel: the stages in their order.
#include "voxc/Kernel/Compile.h"

#include "Stages.h"

#include "voxc/Emit/Emit.h"

namespace voxc {

Expected<Kernel> compileGlsl(std::string_view glsl, const Plan &plan, bool optimise) {
  auto module = glslToSpirv({.glsl = glsl});
  if (module && optimise)
    module = optimiseSpirv(*module);
  if (!module)
    return module.error();
  Kernel kernel{{}, plan.layout.storageDigest, plan.addressing, plan.loops, plan.arithmetic};
  kernel.spirv = addModuleProcessed(*module, kernelFacts(kernel));
  if (auto valid = validateSpirv(kernel.spirv); !valid)
    return valid.error();
  return kernel;
}

Expected<Kernel> compileKernel(const Format &format, const KernelOptions &options) {
  const auto plan = makePlan(format, {options.addressing, options.loops, options.arithmetic});
  if (!plan)
    return plan.error();
  return compileGlsl(emitIntersect(*plan), *plan, options.optimise);
}

Expected<std::vector<std::uint32_t>> compileRayShader(const Plan &plan, std::string_view name,
                                                      RayStage stage) {
  constexpr EShLanguage kStages[] = {EShLangIntersect, EShLangClosestHit};
  const std::string glsl = emitRayShader(plan, name, stage);
  const std::string header = emitHeader(plan, name);
  const std::string headerName = headerFile(name);
  auto module = glslToSpirv({kStages[static_cast<std::size_t>(stage)], glsl, headerName, header});
  if (!module)
    return module;
  if (auto valid = validateSpirv(*module); !valid)
    return valid.error();
  return module;
}

Expected<std::string> disassemble(const Kernel &kernel) { return disassembleSpirv(kernel.spirv); }

} // namespace voxc
