// From a format to a kernel: the stages in their order.
#include "voxc/Kernel/Compile.h"

#include "Stages.h"

#include "voxc/Emit/Emit.h"

namespace voxc {

Expected<Kernel> compileGlsl(std::string_view glsl, const Plan &plan, bool optimise) {
  auto module = glslToSpirv(glsl);
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

Expected<std::string> disassemble(const Kernel &kernel) { return disassembleSpirv(kernel.spirv); }

} // namespace voxc
