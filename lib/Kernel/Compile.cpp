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
  const std::uint64_t digest = plan.layout.storageDigest;
  SpirvWords finished = addModuleProcessed(*module, kernelFacts(digest, plan.addressing, plan.loops));
  if (auto valid = validateSpirv(finished); !valid)
    return valid.error();
  return Kernel{std::move(finished), digest, plan.addressing, plan.loops};
}

Expected<Kernel> compileKernel(const Format &format, const KernelOptions &options) {
  const Plan plan = makePlan(format, {options.addressing, options.loops});
  return compileGlsl(emitIntersect(plan), plan, options.optimise);
}

Expected<std::string> disassemble(const Kernel &kernel) { return disassembleSpirv(kernel.spirv); }

} // namespace voxc
